#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "app/sweep_texts.hpp"
#include "support/folder.hpp"
#include "sweep/readable_number.hpp"
#include "sweep/sweep_cases.hpp"
#include "sweep/sweep_file.hpp"
#include "toml/toml_value.hpp"

// Values between two ends, axes of several quantities, and words of values.

namespace myo::sweep::sweep_axes_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A sweep file with these tables.
Result<Sweep> read_axes(const std::string& tables, const std::string& command = "calibrate",
                        const SweepPolicy& policy = {}) {
    const test::Folder folder("sweep_axes");
    test::write_sweep(folder, test::sweep_head(command) + tables);
    return read_sweep(folder.path() / "sweep.toml", policy);
}

std::string ranged(const std::string& from, const std::string& to, const std::string& count,
                   const std::string& more = {}) {
    return "[[vary]]\nkey = \"material.damping_s\"\nfrom = " + from + "\nto = " + to + "\ncount = " + count + "\n" +
           more;
}

std::vector<double> values_in(const Result<Sweep>& read, std::size_t k = 0) {
    std::vector<double> values;
    if (!read) ADD_FAILURE() << read.error().text();
    if (read)
        for (const toml::TomlValue& value : read->varied[k].values) values.push_back(value.number);
    return values;
}

toml::TomlValue value_of(const std::string& text) { return *toml::parse_toml_value(text, "here"); }

/// The thirds of 0.1 ... 0.4 are not doubles; they read as they would be typed.
TEST(SweepAxes, ValuesBetweenTheEndsAreReadableAndTheEndsAreExact) {
    EXPECT_THAT(values_in(read_axes(ranged("0.1", "0.4", "4"))), ElementsAre(0.1, 0.2, 0.3, 0.4));
    EXPECT_THAT(values_in(read_axes(ranged("-1.0", "1.0", "3"))), ElementsAre(-1.0, 0.0, 1.0));
    EXPECT_THAT(values_in(read_axes(ranged("2.0", "1.0", "3"))), ElementsAre(2.0, 1.5, 1.0));
    // More digits than the policy keeps between them.
    const double odd = 0.12345678901234567;
    const std::vector<double> values = values_in(read_axes(ranged("0.12345678901234567", "0.5", "2")));
    EXPECT_THAT(values, ElementsAre(odd, 0.5));
}

TEST(SweepAxes, LogarithmicValuesHaveAConstantFactor) {
    const std::vector<double> values = values_in(read_axes(ranged("1e-3", "1e2", "6", "spacing = \"log\"\n")));
    EXPECT_THAT(values, ElementsAre(1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0));
    const std::vector<double> odd = values_in(read_axes(ranged("3.0", "7.0", "5", "spacing = \"log\"\n")));
    ASSERT_EQ(odd.size(), 5u);
    for (std::size_t i = 0; i + 1 < odd.size(); ++i)
        EXPECT_NEAR(odd[i + 1] / odd[i], std::pow(7.0 / 3.0, 0.25), 1e-11) << i;
    const Result<Sweep> read = read_axes(ranged("3.0", "7.0", "5", "spacing = \"log\"\n") +
                                         test::axis("material.density_kg_m3", "[1.0]"));
    EXPECT_TRUE(read->varied[0].logarithmic);
    EXPECT_FALSE(read->varied[1].logarithmic);
}

TEST(SweepAxes, OneValueIsTheFirst) {
    EXPECT_THAT(values_in(read_axes(ranged("2.0", "9.0", "1"))), ElementsAre(2.0));
    EXPECT_THAT(values_in(read_axes(ranged("2.0", "9.0", "1", "spacing = \"log\"\n"))), ElementsAre(2.0));
}

TEST(SweepAxes, SeedsAreCountedFromOneOrListed) {
    const std::string first = test::axis("material.damping_s", "[0.001]");
    const Result<Sweep> counted = read_axes("seeds = 3\n" + first), listed = read_axes("seeds = [7, 0]\n" + first);
    EXPECT_THAT(values_in(counted, 1), ElementsAre(1.0, 2.0, 3.0));
    EXPECT_THAT(values_in(listed, 1), ElementsAre(7.0, 0.0));
    EXPECT_EQ(counted->varied[1].name, "--seed");
    EXPECT_TRUE(counted->varied[1].is_option());
    // Seeds alone are a sweep as well.
    EXPECT_EQ(case_count(*read_axes("seeds = 5\n")), 5u);
}

TEST(SweepAxes, QuantitiesThatMoveTogetherAreOneAxis) {
    const std::string tables = test::axis("material.damping_s", "[1e-3, 2e-3]") +
                               test::axis("material.density_kg_m3", "[900, 1000, 1100]") +
                               test::axis("material.youngs_modulus_Pa", "[1e4, 2e4, 3e4]") + "together = true\n" +
                               test::axis("--dt", "[1e-3, 2e-3, 4e-3]") + "together = true\n" +
                               test::axis("--resolution", "[0.01, 0.02, 0.005, 0.004]");
    const Result<Sweep> read = read_axes(tables);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_THAT(axis_sizes(*read), ElementsAre(2u, 3u, 4u));
    EXPECT_EQ(case_count(*read), 24u);
    EXPECT_EQ(case_count(Sweep{}), 1u);
    EXPECT_THAT(axis_sizes(Sweep{}), testing::IsEmpty());
}

TEST(SweepAxes, TheLimitOfCasesIsAllowedAndOneMoreIsNot) {
    const SweepPolicy six{.most_cases = 6};
    const std::string two = test::axis("material.damping_s", "[1e-3, 2e-3]");
    EXPECT_TRUE(read_axes(two + test::axis("--dt", "[1, 2, 3]"), "calibrate", six));
    const Result<Sweep> eight = read_axes(two + test::axis("--dt", "[1, 2, 3, 4]"), "calibrate", six);
    ASSERT_FALSE(eight);
    EXPECT_THAT(eight.error().text(), HasSubstr("vary: the grid has 8 cases; the limit is 6"));
    // Values that move together count once.
    EXPECT_TRUE(read_axes(
        test::axis("material.damping_s", "[1, 2, 3, 4]") + test::axis("--dt", "[1, 2, 3, 4]") + "together = true\n",
        "calibrate", six));
    EXPECT_FALSE(read_axes("seeds = 7\n", "calibrate", six));
    EXPECT_FALSE(read_axes(ranged("1.0", "2.0", "7"), "calibrate", six));
}

struct Refused {
    std::string tables, sentence;
};

TEST(SweepAxes, MistakesOfAxesAreRefused) {
    const std::string one = test::axis("material.damping_s", "[1e-3]");
    const std::vector<Refused> cases{
        {one + "together = true\n", "vary[0].together: there is no [[vary]] before it"},
        {"[[vary]]\noption = \"dt\"\nvalues = [1]\n", "vary[0].option: must begin with --"},
        {"[[vary]]\nkey = \"--dt\"\nvalues = [1]\n", "vary[0].key: must not begin with --"},
        {"[[vary]]\nkey = \"a\"\noption = \"--dt\"\nvalues = [1]\n", "vary[0].key: name either"},
        {"[[vary]]\nkey = \"material.damping_s\"\nvalues = 3\n", "vary[0].values: must be an array, not a number"},
        {test::axis("material.damping_s", "[1979-05-27]"), "vary[0].values: value 0 cannot be a value of a key"},
        {test::axis("markers.rest_m.tip", "[[0, nan, 0]]"), "vary[0].values: value 0 cannot be a value of a key"},
        {test::axis("--threads", "[1]"), "--threads is set by the sweep itself"},
        {test::axis("--resume", "[true]"), "--resume is set by the sweep itself"},
        {ranged("1.0", "2.0", "0"), "vary[0].count"},
        {ranged("1.0", "-2.0", "2", "spacing = \"log\"\n"), "vary[0].to: must be positive"},
        {ranged("1.0", "2.0", "2", "spacing = \"cubic\"\n"), "vary[0].spacing"},
        {"seeds = [-1]\n" + one, "seeds: must be whole numbers from 0 on"},
        {"seeds = [\"1\"]\n" + one, "seeds: must be whole numbers from 0 on"},
        {"seeds = []\n" + one, "seeds: holds no value"},
        {"seeds = 0\n" + one, "seeds"},
        {"seeds = 2.5\n" + one, "seeds: must be a whole number"},
        {"seeds = 2\n" + test::axis("--seed", "[1, 2]"), "seeds: --seed is varied by [[vary]] as well"},
    };
    for (const Refused& c : cases) {
        const Result<Sweep> read = read_axes(c.tables);
        ASSERT_FALSE(read) << c.tables;
        EXPECT_THAT(read.error().text(), HasSubstr(c.sentence));
        EXPECT_THAT(read.error().text(), HasSubstr("sweep.toml:"));
    }
}

/// An option that the sweep sets is also recognised with its value in one word.
TEST(SweepAxes, ArgumentsOfTheSweepItselfAreRefusedInBothSpellings) {
    const test::Folder folder("sweep_arguments");
    for (const char* word : {"--out", "--out=x", "--threads=4", "--quiet", "--json-progress", "-h"}) {
        test::write_sweep(folder,
                          "schema = \"sweep/1\"\nexperiment = \"exp\"\ncommand = \"calibrate\"\narguments = [\"" +
                              std::string(word) + "\"]\nseeds = 2\n");
        const Result<Sweep> read = read_sweep(folder.path() / "sweep.toml");
        ASSERT_FALSE(read) << word;
        EXPECT_THAT(read.error().text(), HasSubstr(":4: arguments: " + std::string(word) + " is set by the sweep"));
    }
}

TEST(SweepAxes, WordsOfValuesAreThoseThatAnOptionTakes) {
    Varied varied{.name = "--x", .values = {}, .where = {}};
    const std::pair<const char*, const char*> typed[] = {{"\"hex8\"", "hex8"},
                                                         {"true", "true"},
                                                         {"320000", "320000"},
                                                         {"3.2e5", "320000"},
                                                         {"1e6", "1000000"},
                                                         {"-2.0", "-2"},
                                                         {"0.01", "0.01"},
                                                         {"1e-7", "1e-07"},
                                                         {"1e300", "1e+300"},
                                                         {"inf", "inf"},
                                                         {"[0.0, 1]", "[0.0, 1.0]"},
                                                         {"0.30", "0.3"},
                                                         {"123456789012345", "123456789012345"}};
    for (const auto& [text, expected] : typed) {
        varied.values = {value_of(text)};
        EXPECT_EQ(value_words(varied, 0), expected) << text;
    }
}

TEST(SweepAxes, VariedQuantitiesAreShownInReadableUnits) {
    const auto shown = [](const std::string& name) {
        return shown_quantity(Varied{.name = name, .values = {}, .where = {}});
    };
    EXPECT_EQ(shown("--resolution").unit, "mm");
    EXPECT_EQ(shown("--resolution").factor, 1e3);
    EXPECT_EQ(shown("--dt").unit, "ms");
    EXPECT_EQ(shown("--dt").factor, 1e3);
    EXPECT_EQ(shown("--seed").unit, "");
    EXPECT_EQ(shown("--seed").factor, 1.0);
    // An option is named as it is typed, whatever it ends in.
    EXPECT_EQ(shown("--max_m").name, "--max_m");
    EXPECT_EQ(shown("material.damping_s").name, "material.damping");
    EXPECT_EQ(shown("material.damping_s").unit, "ms");
    EXPECT_EQ(shown("density_kg_m3").name, "density");
    EXPECT_EQ(shown("trial[0].start").factor, 1.0);
}

TEST(SweepAxes, NumbersOfAReportAreShownInTheirUnit) {
    EXPECT_EQ(words_of({"rms of drop", "m", 1.23456e-3}), "1.235 mm");
    EXPECT_EQ(words_of({"left", "N", 0.25, 0.013}), "250 ± 13 mN");
    EXPECT_EQ(words_of({"weight", "kg", 0.02}), "20 g");
    EXPECT_EQ(words_of({"damping_s", "s", 4e-3, 0.0}), "4 ± 0 ms");
    EXPECT_EQ(words_of({"remaining distance", "noise levels", 2.5}), "2.5 noise levels");
    EXPECT_EQ(words_of({"modulus", "Pa", 2e5, std::numeric_limits<double>::infinity()}), "200 kPa");
    // A name without that unit keeps all its words.
    EXPECT_EQ(shown_quantity("length_m", "Pa").name, "length_m");
    EXPECT_EQ(shown_quantity("length_m", "m").name, "length");
}

}  // namespace
}  // namespace myo::sweep::sweep_axes_test
