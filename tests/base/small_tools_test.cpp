#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "base/box.hpp"
#include "base/cross_matrix.hpp"
#include "base/fingerprint.hpp"
#include "base/letter_case.hpp"
#include "base/name_table.hpp"
#include "base/random_stream.hpp"

// Random numbers by key, hashes, names of values, letters, boxes, cross products.

namespace myo::small_tools_test {
namespace {

std::vector<double> first_of(std::initializer_list<std::uint64_t> key) {
    RandomStream stream(key);
    return {stream.uniform(0.0, 1.0), stream.uniform(0.0, 1.0), stream.uniform(0.0, 1.0)};
}

TEST(RandomStream, DependsOnEveryPartOfItsKeyAndItsOrder) {
    EXPECT_EQ(first_of({3, 7}), first_of({3, 7}));
    const std::vector<std::vector<double>> streams{first_of({}),     first_of({0}),    first_of({1}),
                                                   first_of({3}),    first_of({3, 7}), first_of({7, 3}),
                                                   first_of({3, 8}), first_of({0, 0}), first_of({3, 7, 0})};
    for (std::size_t a = 0; a < streams.size(); ++a)
        for (std::size_t b = 0; b < a; ++b)
            for (std::size_t k = 0; k < 3; ++k) EXPECT_NE(streams[a][k], streams[b][k]) << a << " " << b;
}

/// Means and deviations of 20,000 numbers, five standard errors wide.
TEST(RandomStream, HasTheMomentsOfItsDistributions) {
    const int count = 20000;
    RandomStream stream({1, 2, 3});
    double uniform = 0.0, logarithm = 0.0, normal = 0.0, square = 0.0, sign = 0.0, heads = 0.0;
    std::array<int, 7> faces{};
    for (int i = 0; i < count; ++i) {
        const double u = stream.uniform(-2.0, 6.0), l = stream.log_uniform(1e-3, 10.0), n = stream.normal();
        EXPECT_TRUE(u >= -2.0 && u < 6.0);
        EXPECT_TRUE(l >= 1e-3 && l < 10.0 * (1.0 + 1e-12));
        uniform += u / count, logarithm += std::log10(l) / count, normal += n / count, square += n * n / count;
        sign += stream.sign() / count, heads += stream.chance(0.2) ? 1.0 / count : 0.0;
        const int face = stream.below(7);
        ASSERT_TRUE(face >= 0 && face < 7);
        ++faces[static_cast<std::size_t>(face)];
    }
    const double error = 5.0 / std::sqrt(count);
    EXPECT_NEAR(uniform, 2.0, error * 8.0 / std::sqrt(12.0));
    EXPECT_NEAR(logarithm, -1.0, error * 4.0 / std::sqrt(12.0));
    EXPECT_NEAR(normal, 0.0, error);
    EXPECT_NEAR(square, 1.0, error * std::sqrt(2.0));
    EXPECT_NEAR(sign, 0.0, error);
    EXPECT_NEAR(heads, 0.2, error * 0.4);
    for (const int times : faces) EXPECT_NEAR(times / (count / 7.0), 1.0, error * std::sqrt(6.0));
    EXPECT_EQ(stream.below(1), 0);
    EXPECT_FALSE(stream.chance(0.0));
    EXPECT_TRUE(stream.chance(1.0));
}

std::uint64_t hash_of(const std::vector<double>& values) {
    Fingerprint print;
    print.add(values.data(), static_cast<std::ptrdiff_t>(values.size()));
    return print.value();
}

TEST(Fingerprint, TellsBitsOrderAndNumberApart) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(hash_of({1.0, 2.0}), hash_of({1.0, 2.0}));
    EXPECT_EQ(hash_of({nan}), hash_of({-std::nan("7")})) << "there are many, but one meaning";
    const std::vector<std::vector<double>> lists{
        {}, {0.0}, {-0.0}, {0.0, 0.0}, {1.0}, {std::nextafter(1.0, 2.0)}, {1.0, 2.0}, {2.0, 1.0}, {nan}};
    for (std::size_t a = 0; a < lists.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) EXPECT_NE(hash_of(lists[a]), hash_of(lists[b])) << a << " " << b;
    Fingerprint at_once, one_by_one;
    Eigen::Matrix2d matrix;
    matrix << 1.0, 3.0, 2.0, 4.0;
    at_once.add_all(matrix);
    for (const double value : {1.0, 2.0, 3.0, 4.0}) one_by_one.add(value);
    EXPECT_EQ(at_once.value(), one_by_one.value()) << "columns one after the other";
}

TEST(Fingerprint, KeepsTextsApart) {
    const auto of_texts = [](const std::vector<std::string>& texts) {
        Fingerprint print;
        for (const std::string& text : texts) print.add_text(text);
        return print.value();
    };
    EXPECT_NE(of_texts({"ab", "c"}), of_texts({"a", "bc"}));
    EXPECT_NE(of_texts({"abc"}), of_texts({"abc", ""}));
    EXPECT_NE(of_texts({std::string("a\0b", 3)}), of_texts({"a"}));
}

enum class Colour { red, green, grey };
constexpr NameTable<Colour, 2> colours{{{{Colour::red, "red"}, {Colour::green, "green"}}}};

TEST(NameTable, FindsBothWays) {
    EXPECT_EQ(colours.name(Colour::green), "green");
    EXPECT_EQ(colours.name(Colour::grey), "") << "not in the table";
    EXPECT_EQ(colours.names(), (std::vector<std::string>{"red", "green"}));
    Colour found = Colour::grey;
    EXPECT_FALSE(colours.find("Red", found));
    EXPECT_EQ(found, Colour::grey) << "unchanged";
    EXPECT_TRUE(colours.find("red", found));
    EXPECT_EQ(found, Colour::red);
}

TEST(LetterCase, ChangesAsciiOnly) {
    EXPECT_EQ(lower_case("MiXed 9.CSV"), "mixed 9.csv");
    EXPECT_EQ(lower_case("\xC3\x84"
                         "A"),
              "\xC3\x84"
              "a")
        << "other letters stay whole";
    EXPECT_EQ(lower_first("The Beam"), "the Beam");
    EXPECT_EQ(upper_first("the beam"), "The beam");
    EXPECT_EQ(upper_first("\xC3\xA4"
                          "b"),
              "\xC3\xA4"
              "b");
    for (const char* same : {"", "9 marks", "_x"}) {
        EXPECT_EQ(lower_first(same), same);
        EXPECT_EQ(upper_first(same), same);
    }
}

TEST(Box, HoldsItsSides) {
    const Box box{{-1.0, 0.0, 2.0}, {1.0, 0.0, 5.0}};
    EXPECT_EQ(box.size(), Eigen::Vector3d(2.0, 0.0, 3.0));
    for (const Eigen::Vector3d& corner : {box.lowest, box.highest}) EXPECT_TRUE(box.contains(corner));
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            Eigen::Vector3d beyond = side < 0.0 ? box.lowest : box.highest;
            beyond[axis] = std::nextafter(beyond[axis], side * 10.0);
            EXPECT_FALSE(box.contains(beyond)) << axis;
        }
    EXPECT_FALSE(box.contains({std::numeric_limits<double>::quiet_NaN(), 0.0, 3.0}));
}

TEST(CrossMatrix, IsTheProductFromTheLeft) {
    const Eigen::Vector3d v(0.3, -1.2, 2.0), p(5.0, 0.7, -0.1);
    EXPECT_LT((cross_matrix(v) * p - v.cross(p)).norm(), 1e-15);
    EXPECT_EQ(cross_matrix(v).transpose(), -cross_matrix(v));
    EXPECT_LT((cross_matrix(v) * v).norm(), 1e-15);
}

}  // namespace
}  // namespace myo::small_tools_test
