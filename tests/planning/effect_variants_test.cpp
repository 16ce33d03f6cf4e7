#include "planning/effect_variants.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "effect/catalogue.hpp"

// Sizes of effects over their plausible ranges, and the forms of an effect that a power map runs.

namespace myo::planning::effect_variants_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// An effect with a size "amount" between 1 and 100 and a range of 0 to 50.
effect::Effect made_effect() {
    effect::Effect made;
    made.id = "made";
    made.draw.amount = "amount";
    made.draw.lowest = 1.0;
    made.draw.highest = 100.0;
    effect::EffectParameterEntry entry;
    entry.name = "amount";
    entry.lowest = -50.0;
    entry.highest = 50.0;
    made.parameters = {entry};
    return made;
}

TEST(EffectSizes, AreEqualRatiosFromWeakToStrong) {
    effect::Effect made = made_effect();
    const std::vector<double> sizes = effect_sizes(made, 5);
    ASSERT_EQ(sizes.size(), 5u);
    EXPECT_DOUBLE_EQ(sizes.front(), 1.0);
    EXPECT_DOUBLE_EQ(sizes.back(), 100.0);
    for (std::size_t i = 1; i < sizes.size(); ++i) EXPECT_NEAR(sizes[i] / sizes[i - 1], std::sqrt(10.0), 1e-12);
    EXPECT_THAT(effect_sizes(made, 1), ElementsAre(1.0));
    EXPECT_THAT(effect_sizes(made, 0), IsEmpty());
    made.draw.grows = false;  // a stiffness of the clamp: the largest is the weakest
    EXPECT_DOUBLE_EQ(effect_sizes(made, 3).front(), 100.0);
    EXPECT_DOUBLE_EQ(effect_sizes(made, 3).back(), 1.0);
    made.draw.lowest = 0.0;
    EXPECT_THAT(effect_sizes(made, 3), IsEmpty()) << "no ratio leads away from 0";
    made = made_effect();
    made.draw.amount.clear();
    EXPECT_THAT(effect_sizes(made, 3), IsEmpty());
}

/// Every entry of the catalogue with an amount has sizes within the range of that parameter.
TEST(EffectSizes, OfTheCatalogueLieWithinTheirRanges) {
    int with_size = 0;
    for (const effect::Effect* const entry : effect::all_effects({})) {
        const std::vector<double> sizes = effect_sizes(*entry, 3);
        if (sizes.empty()) continue;
        ++with_size;
        ASSERT_EQ(sizes.size(), 3u) << entry->id;
        EXPECT_EQ(sizes.front() < sizes.back(), entry->draw.grows) << entry->id;
        const effect::EffectParameterEntry* const parameter = entry->parameter(entry->draw.amount);
        ASSERT_NE(parameter, nullptr) << entry->id << " has no " << entry->draw.amount;
        if (parameter->kind != effect::EffectParameterKind::number) continue;
        for (const double size : sizes) {
            EXPECT_GE(size, parameter->lowest) << entry->id;
            EXPECT_LE(size, parameter->highest) << entry->id;
        }
    }
    EXPECT_GE(with_size, 10);
}

/// The only column of a variant with this value and this size.
effect::EffectParameter sized(const effect::EffectParameter& value, std::optional<double> size) {
    const effect::Effect made = made_effect();
    const std::vector<effect::EffectParameters> columns = sized_columns({&made, {{{"amount", value}}}}, size);
    EXPECT_EQ(columns.size(), 1u);
    return columns.empty() ? effect::EffectParameter("none") : columns.front().at("amount");
}

TEST(SizedColumns, KeepSignAndDirectionWithinTheRange) {
    EXPECT_EQ(std::get<double>(sized(3.0, 20.0)), 20.0);
    EXPECT_EQ(std::get<double>(sized(-3.0, 20.0)), -20.0);
    EXPECT_EQ(std::get<double>(sized(3.0, 80.0)), 50.0);
    EXPECT_EQ(std::get<double>(sized(-3.0, 80.0)), -50.0);
    EXPECT_EQ(std::get<double>(sized(3.0, std::nullopt)), 3.0);
    const auto vector_of = [](const Eigen::Vector3d& value, double size) {
        return Eigen::Vector3d(std::get<Eigen::VectorXd>(sized(Eigen::VectorXd(value), size)));
    };
    const Eigen::Vector3d slanted(3.0, 0.0, -4.0);
    EXPECT_TRUE(vector_of(slanted, 20.0).isApprox(4.0 * slanted));
    EXPECT_EQ(vector_of(Eigen::Vector3d::Zero(), 20.0), Eigen::Vector3d::Zero()) << "without a direction";
}

TEST(SizedColumns, AreNoneWhereAColumnHasNoAmount) {
    const effect::Effect made = made_effect();
    const effect::EffectParameters good{{"amount", 1.0}, {"place", 7.0}}, without{{"place", 7.0}},
        named{{"amount", std::string("tip")}};
    const EffectVariant both{&made, {good, without}}, name{&made, {named}}, pair{&made, {good, good}};
    EXPECT_THAT(sized_columns(both, 2.0), IsEmpty());
    EXPECT_THAT(sized_columns(name, 2.0), IsEmpty());
    EXPECT_EQ(sized_columns(both, std::nullopt).size(), 2u) << "without a size they are as they are";
    const std::vector<effect::EffectParameters> sized_pair = sized_columns(pair, 2.0);
    ASSERT_EQ(sized_pair.size(), 2u);
    for (const effect::EffectParameters& column : sized_pair) {
        EXPECT_EQ(std::get<double>(column.at("amount")), 2.0);
        EXPECT_EQ(std::get<double>(column.at("place")), 7.0) << "only the amount is changed";
    }
    EXPECT_EQ(std::get<double>(pair.columns[0].at("amount")), 1.0) << "the variant is left as it is";
}

/// Numbers of the probes that are chosen, of as many small and large ones.
std::vector<double> chosen(int small, int large, std::size_t most) {
    effect::Effect made = made_effect();
    made.probes = [small, large](const effect::EffectSearch&) {
        std::vector<effect::EffectProbe> probes(static_cast<std::size_t>(small + large));
        for (std::size_t i = 0; i < probes.size(); ++i) {
            probes[i].columns = {{{"amount", static_cast<double>(i)}}};
            probes[i].large = i < static_cast<std::size_t>(large);  // the first ones
        }
        return probes;
    };
    PowerPolicy policy;
    policy.most_forms = most;
    std::vector<double> numbers;
    for (const EffectVariant& variant : effect_variants(made, {}, {}, {0}, policy))
        numbers.push_back(std::get<double>(variant.columns.at(0).at("amount")));
    return numbers;
}

TEST(EffectVariants, AreEvenlyChosenAmongSmallProbes) {
    EXPECT_THAT(chosen(3, 0, 4), ElementsAre(0.0, 1.0, 2.0));
    EXPECT_THAT(chosen(8, 0, 4), ElementsAre(0.0, 2.0, 4.0, 6.0));
    EXPECT_THAT(chosen(7, 0, 3), ElementsAre(0.0, 2.0, 4.0));
    EXPECT_THAT(chosen(2, 3, 4), ElementsAre(3.0, 4.0)) << "large ones only where there are no others";
    EXPECT_THAT(chosen(0, 3, 2), ElementsAre(0.0, 1.0));
    EXPECT_THAT(chosen(0, 0, 4), IsEmpty()) << "the trials cannot show it";
    EXPECT_THAT(chosen(5, 0, 1), ElementsAre(0.0));
}

}  // namespace
}  // namespace myo::planning::effect_variants_test
