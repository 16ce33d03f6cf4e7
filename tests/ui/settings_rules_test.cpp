#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "commands/seek_choice.hpp"
#include "commands/settings_difference.hpp"
#include "commands/step_cost.hpp"
#include "commands/switched_off.hpp"
#include "effect/readable_quantity.hpp"
#include "ui/swinging_beam.hpp"

// Limits of the settings, the words of their differences, and what is offered for them.

namespace myo::ui::settings_rules {
namespace {

using commands::Settings;
using Texts = std::vector<std::string>;
const std::string none = "–";

TEST(SettingsLimits, HoldEveryNumberAndNothingElse) {
    using Number = double Settings::*;
    const std::vector<std::pair<Number, commands::Limits>> numbers{
        {&Settings::youngs_modulus_Pa, commands::youngs_modulus_limits},
        {&Settings::poissons_ratio, commands::poissons_ratio_limits},
        {&Settings::density_kg_m3, commands::density_limits},
        {&Settings::damping_s, commands::damping_limits},
        {&Settings::time_step_s, commands::time_step_limits},
        {&Settings::spectral_radius, commands::spectral_radius_limits},
        {&Settings::velocity_force_1_s, commands::velocity_force_limits}};
    for (const auto& [number, limits] : numbers) {
        const double middle = 0.5 * (limits.lowest + limits.highest);
        for (const auto& [asked, kept] :
             std::vector<std::pair<double, double>>{{limits.lowest - 1.0, limits.lowest},
                                                    {limits.lowest, limits.lowest},
                                                    {middle, middle},
                                                    {limits.highest, limits.highest},
                                                    {2.0 * limits.highest + 1.0, limits.highest}}) {
            Settings settings, expected;
            settings.*number = asked;
            expected.*number = kept;
            EXPECT_EQ(commands::within_limits(settings), expected) << asked << " of " << limits.lowest;
        }
    }
    Settings settings;
    settings.muscles.resize(2);
    settings.muscles[0].stiffness_Pa = 0.0;
    settings.muscles[0].ratio = -11.0;
    settings.muscles[1].stiffness_Pa = 1e10;
    settings.muscles[1].ratio = 11.0;
    const Settings limited = commands::within_limits(settings);
    EXPECT_EQ(limited.muscles[0].stiffness_Pa, commands::muscle_stiffness_limits.lowest);
    EXPECT_EQ(limited.muscles[1].stiffness_Pa, commands::muscle_stiffness_limits.highest);
    EXPECT_EQ(limited.muscles[0].ratio, commands::muscle_ratio_limits.lowest);
    EXPECT_EQ(limited.muscles[1].ratio, commands::muscle_ratio_limits.highest);
    EXPECT_EQ(commands::within_limits(limited), limited);
}

/// Rows in which settings differ, as "name: first | second | ...".
Texts differences(const std::vector<Settings>& all) {
    const test::SwingingBeam beam;
    std::vector<const Settings*> of;
    for (const Settings& settings : all) of.push_back(&settings);
    Texts lines;
    for (const commands::SettingDifference& row :
         commands::settings_differences(of, beam.materials(), beam.integrators())) {
        std::string line = row.name + ":";
        for (const std::string& value : row.values) line += (line.back() == ':' ? " " : " | ") + value;
        lines.push_back(line);
    }
    return lines;
}

template <class Edit>
Settings edited(const Edit& edit) {
    Settings settings;
    settings.material = "neo_hookean";
    settings.integrator = "tr_bdf2";
    edit(settings);
    return settings;
}

TEST(SettingsDifferences, AreInTheUnitsOfTheFields) {
    const Settings usual = edited([](Settings&) {});
    const auto line = [&](const auto& edit) {
        const Texts lines = differences({usual, edited(edit)});
        return lines.size() == 1 ? lines[0] : std::to_string(lines.size()) + " lines";
    };
    EXPECT_EQ(line([](Settings& s) { s.resolution_m = 0.0075; }), "Edge length: 5 mm | 7.5 mm");
    EXPECT_EQ(line([](Settings& s) { s.youngs_modulus_Pa = 1.5e6; }), "Young's modulus E: 260 kPa | 1500 kPa");
    EXPECT_EQ(line([](Settings& s) { s.poissons_ratio = 0.4999; }), "Poisson's ratio ν: 0.49 | 0.4999");
    EXPECT_EQ(line([](Settings& s) { s.density_kg_m3 = 980.0; }), "Density ρ: 1070 kg/m³ | 980 kg/m³");
    EXPECT_EQ(line([](Settings& s) { s.damping_s = 0.0042; }), "Damping time τ: 0 ms | 4.2 ms");
    EXPECT_EQ(line([](Settings& s) { s.spectral_radius = 0.8; }), "Spectral radius ρ∞: 0.5 | 0.8");
    EXPECT_EQ(line([](Settings& s) { s.time_step_s = 0.0025; }), "Time step h: 10 ms | 2.5 ms");
    EXPECT_EQ(line([](Settings& s) { s.velocity_force_1_s = -2.0; }), "Velocity force Λ: 0 1/s | −2 1/s");
    EXPECT_EQ(line([](Settings& s) { s.integrator = "implicit_euler"; }), "Integrator: TR-BDF2 | Implicit Euler");
    EXPECT_EQ(line([](Settings& s) { s.integrator = "former"; }), "Integrator: TR-BDF2 | former")
        << "an id that this version does not know";
    EXPECT_EQ(
        line([](Settings& s) {
            s.off = {{0, "linear_drag"}, {2, "dry_friction"}};
        }),
        "Effects switched off: – | " + effect::effect_name("linear_drag") + ", " + effect::effect_name("dry_friction"));
}

TEST(SettingsDifferences, NumbersOfALawAreThoseOfItsUsers) {
    const Settings plain = edited([](Settings&) {}), gent = edited([](Settings&s) { s.material = "gent"; }),
                   other = edited([](Settings&s) {
                       s.material = "gent";
                       s.law["gent_limit"] = 12.0;
                   });
    EXPECT_EQ(differences({gent, other}), (Texts{"Limit J: 30 | 12"})) << "one that is not set has its usual value";
    EXPECT_EQ(differences({plain, gent, other}),
              (Texts{"Material: neo-Hookean | Gent | Gent", "Limit J: – | 30 | 12"}));
    // Kept for later, but of no effect on the law in use.
    const Settings unused = edited([](Settings& s) { s.law["gent_limit"] = 12.0; });
    EXPECT_EQ(differences({plain, unused}), Texts{});
}

TEST(SettingsDifferences, OfMusclesAreTheirPlaceStiffnessAndSignal) {
    const auto with = [](const std::vector<commands::Muscle>& muscles) {
        return edited([&](Settings& s) { s.muscles = muscles; });
    };
    commands::Muscle declared;
    declared.name = "upper";
    declared.declared = "left";
    commands::Muscle painted = declared;
    painted.paint = std::make_shared<const fibre::PaintedMask>();
    painted.stiffness_Pa = 9.5e4;
    painted.signal = fibre::Signal{{0.0, 1.0, 2.0}, {1.0, 0.7, 0.9}};
    EXPECT_EQ(differences({with({declared}), with({painted})}),
              (Texts{"upper, place: as declared | painted", "upper, stiffness: 80 kPa | 95 kPa",
                     "upper, signal: as recorded | a 0.7 to 1, 3 knots"}));
    commands::Muscle follower;
    follower.name = "lower";
    follower.follows = "upper";
    follower.ratio = -0.5;
    EXPECT_EQ(differences({with({declared, follower}), with({declared})}),
              (Texts{"lower, place: nowhere | –", "lower, stiffness: 80 kPa | –", "lower, sought: yes | –",
                     "lower, signal: −0.5 × upper | –"}));
    // A signal of its own does not count while the muscle follows another.
    commands::Muscle with_signal = follower;
    with_signal.signal = fibre::Signal::constant(0.5);
    EXPECT_EQ(differences({with({follower}), with({with_signal})}), Texts{});
}

TEST(SettingsDifferences, WhatDiffersNeverReadsAlike) {
    const Settings a = edited([](Settings&) {}), b = edited([](Settings&s) { s.youngs_modulus_Pa += 1e-3; });
    EXPECT_EQ(differences({a, b}), (Texts{"Young's modulus E: 260 kPa | 260 kPa (other)"}));
    EXPECT_EQ(differences({a, b, a}), (Texts{"Young's modulus E: 260 kPa | 260 kPa (other) | 260 kPa"}));
    EXPECT_EQ(differences({a, a, a}), Texts{});
    EXPECT_EQ(differences({a}), Texts{});
    EXPECT_EQ(differences({}), Texts{});
}

TEST(SeekChoices, FollowTheNamesAndThePaintOfTheMuscles) {
    const std::vector<commands::SeekChoice> declared{{"direction:left", "Fibre direction of left", "left"},
                                                     {"direction:gone", "Fibre direction of gone", "gone"},
                                                     {"modulus", "Young's modulus"}};
    Settings settings;
    const auto words = [&] {
        std::string all;
        for (const commands::SeekChoice& choice : commands::seek_choices(declared, settings))
            all += choice.word + " = " + choice.label + "; ";
        return all;
    };
    EXPECT_EQ(words(), "modulus = Young's modulus; ") << "muscles that the settings do not have are not offered";
    settings.muscles.resize(2);
    settings.muscles[0].name = "upper";
    settings.muscles[0].declared = "left";
    settings.muscles[1].name = "own";
    EXPECT_EQ(words(), "direction:upper = Fibre direction of upper; modulus = Young's modulus; ");
    settings.muscles[0].paint = std::make_shared<const fibre::PaintedMask>();
    EXPECT_EQ(words(),
              "direction:upper = Fibre direction of upper; weights:upper = Painted weights of upper; "
              "modulus = Young's modulus; ");
}

TEST(StepCosts, KeepTheNewestOfEachSizeAndNoneWithoutAMeaning) {
    using mesh::CellType;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<commands::StepCost> costs;
    for (const auto& [dofs, seconds] : std::vector<std::pair<double, double>>{
             {0.0, 1.0}, {-3.0, 1.0}, {3.0, 0.0}, {3.0, -1.0}, {nan, 1.0}, {3.0, nan}})
        commands::remember(costs, {CellType::hex8, dofs, seconds});
    EXPECT_TRUE(costs.empty());
    commands::remember(costs, {CellType::hex8, 100.0, 1.0});
    commands::remember(costs, {CellType::tet4, 100.0, 2.0});
    commands::remember(costs, {CellType::hex8, 100.0, 3.0});
    EXPECT_EQ(costs, (std::vector<commands::StepCost>{{CellType::tet4, 100.0, 2.0}, {CellType::hex8, 100.0, 3.0}}));
    for (std::size_t k = 0; k < commands::max_step_costs; ++k)
        commands::remember(costs, {CellType::tet10, 1000.0 + static_cast<double>(k), 1.0});
    ASSERT_EQ(costs.size(), commands::max_step_costs);
    EXPECT_EQ(costs.front().dofs, 1000.0) << "the two oldest are gone";
}

TEST(StepCosts, TheExponentIsThatOfThePowerLawWithinReason) {
    using mesh::CellType;
    const auto predicted = [](double exponent, double ratio) {
        std::vector<commands::StepCost> costs;
        for (const double size : {1.0, std::sqrt(ratio), ratio})
            costs.push_back({CellType::hex8, 1000.0 * size, 1e-3 * std::pow(size, exponent)});
        return commands::predict_step(costs, CellType::hex8, 8000.0);
    };
    EXPECT_NEAR(predicted(1.7, 4.0).exponent, 1.7, 1e-9);
    EXPECT_NEAR(predicted(1.7, 4.0).seconds, 1e-3 * std::pow(8.0, 1.7), 1e-9) << "all lie on one line";
    EXPECT_EQ(predicted(4.0, 4.0).exponent, 2.5);
    EXPECT_EQ(predicted(-1.0, 4.0).exponent, 0.5) << "noise does not make large bodies cheaper";
    EXPECT_TRUE(predicted(1.7, 1.51).fitted);
    EXPECT_FALSE(predicted(1.7, 1.49).fitted) << "sizes that are too near to each other";
    EXPECT_EQ(predicted(1.7, 1.49).exponent, 1.5) << "that of the benchmark";
    // Other elements tell something, too, but not their slope.
    const commands::StepPrediction other = commands::predict_step(
        {{CellType::tet4, 1000.0, 1e-3}, {CellType::tet4, 4000.0, 9e-3}}, CellType::hex8, 4000.0);
    EXPECT_EQ(other.from.dofs, 4000.0);
    EXPECT_DOUBLE_EQ(other.seconds, 9e-3);
    EXPECT_TRUE(other.measured);
    EXPECT_FALSE(other.fitted);
}

}  // namespace
}  // namespace myo::ui::settings_rules
