#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <variant>
#include <vector>

#include "trial_context.hpp"

namespace myo::effect::probes_tests {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

/// Two trials of a held beam with muscles, a weight and all else that effects need to show.
EffectSearch full_search() {
    const test::HeldBeam beam = test::held_beam({6, 2, 2});
    EffectSearch search;
    search.trials = {beam.context, beam.context};
    search.trials[1].trial = "drop again";
    search.trials[1].number = 1;
    search.trials[1].session_time_s = 350.0;
    search.models = {beam.affected.model, beam.affected.model};
    search.largest_energy_density_J_m3 = 100.0;
    return search;
}
std::vector<EffectProbe> probes_of(const std::string& id, const EffectSearch& search) {
    return find_effect(id)->probes(search);
}
VectorXd three(double x, double y, double z) { return Vector3d(x, y, z); }

/// A search begins at values that an experiment could declare: all that are required, and within their ranges.
TEST(ProbesOfTheCatalogue, AreDeclarationsWithinTheirRanges) {
    const EffectSearch search = full_search();
    for (const Effect& effect : effect_catalogue()) {
        if (!effect.probes) continue;
        for (const EffectProbe& probe : effect.probes(search)) {
            ASSERT_FALSE(probe.columns.empty()) << effect.id;
            EXPECT_EQ(probe.joined == nullptr, probe.columns.size() == 1) << effect.id;
            if (!probe.joined) {
                EXPECT_TRUE(has(probe.columns[0], probe.amount)) << effect.id;
                EXPECT_NE(number(probe.columns[0], probe.amount), 0.0) << effect.id;
            }
            for (const EffectParameters& column : probe.columns) {
                for (const EffectParameterEntry& entry : effect.parameters)
                    EXPECT_TRUE(entry.optional || has(column, entry.name)) << effect.id << " " << entry.name;
                for (const auto& [name, value] : column) {
                    const EffectParameterEntry* const entry = effect.parameter(name);
                    ASSERT_TRUE(entry != nullptr || name == "trial") << effect.id << " " << name;
                    if (entry == nullptr) continue;
                    const auto* const single = std::get_if<double>(&value);
                    if (single && entry->kind == EffectParameterKind::number) {
                        EXPECT_TRUE(*single >= entry->lowest && *single <= entry->highest) << effect.id << " " << name;
                    }
                    const auto* const several = std::get_if<VectorXd>(&value);
                    if (several && entry->kind == EffectParameterKind::direction) {
                        EXPECT_NEAR(several->norm(), 1.0, 1e-12) << effect.id << " " << name;
                    }
                    EXPECT_TRUE(!several || several->allFinite()) << effect.id << " " << name;
                }
            }
        }
    }
}

/// What an experiment cannot show is not sought.
TEST(ProbesOfTheCatalogue, AreEmptyWhereNothingCanShow) {
    const EffectSearch whole = full_search();
    using Change = std::function<void(EffectSearch&)>;
    const Change no_signals = [](EffectSearch& search) {
        for (model::Model& model : search.models) model.activation = {fibre::Signal::constant(1.0)};
    };
    const Change held = [](EffectSearch& search) {
        for (model::Model& model : search.models) model.activation = {fibre::Signal::constant(0.8)};
    };
    const Change equilibrium = [](EffectSearch& search) {
        for (TrialContext& trial : search.trials) trial.start = dynamics::StartKind::equilibrium;
    };
    struct Case {
        std::string id;
        Change change;
        bool found;
    };
    for (const Case& c : std::vector<Case>{
             {"gravity_tilt", [](EffectSearch& search) { search.models[0].gravity_m_s2.setZero(); }, false},
             {"hung_mass",
              [](EffectSearch& search) {
                  for (model::Model& model : search.models) model.forces.clear();
              },
              false},
             {"hung_mass", [](EffectSearch& search) { search.models[0].forces.clear(); }, true},
             {"extra_damping", [](EffectSearch& search) { search.damping_is_fitted = true; }, false},
             {"modulus_drift", [](EffectSearch& search) { search.trials[1].session_time_s = 100.0; }, false},
             {"stress_softening", [](EffectSearch& search) { search.largest_energy_density_J_m3 = 0.0; }, false},
             {"tendon_friction", [](EffectSearch&) {}, false},
             {"tendon_channel", [](EffectSearch&) {}, false},
             {"held_pose", equilibrium, false},
             {"actuation_lag", no_signals, false},
             {"actuation_delay", no_signals, false},
             {"actuation_gain", no_signals, false},
             {"actuation_leak", no_signals, false},
             {"actuation_hysteresis", no_signals, false},
             {"actuation_lag", held, false},
             {"actuation_delay", held, false},
             {"actuation_gain", held, true},
             {"actuation_leak", held, true},
             {"actuation_hysteresis", held, true}}) {
        EffectSearch search = whole;
        EXPECT_TRUE(!probes_of(c.id, search).empty() || c.id.starts_with("tendon_")) << c.id;
        c.change(search);
        EXPECT_EQ(!probes_of(c.id, search).empty(), c.found) << c.id;
    }
}

TEST(ProbesOfTheCatalogue, TakeTheirSizeFromTheExperiment) {
    EffectSearch search = full_search();
    const double body_kg = search.models[0].density_kg_m3 * search.trials[0].body->volume_m3;
    for (const EffectProbe& probe : probes_of("point_mass", search))
        EXPECT_NEAR(number(probe.columns[0], "mass_kg"), 0.01 * body_kg, 1e-15);
    EXPECT_NEAR(number(probes_of("modulus_drift", search)[0].columns[0], "rate_1_s") * 250.0, 0.02, 1e-15)
        << "2 % from the first trial to the last";
    search.trials[0].interval_s = 0.004;
    std::vector<double> offsets;
    for (const EffectProbe& probe : probes_of("clock_offset", search))
        offsets.push_back(number(probe.columns[0], "offset_s") / 0.004);
    ASSERT_EQ(offsets.size(), 4u);
    std::sort(offsets.begin(), offsets.end());
    EXPECT_NEAR(offsets[0], -2.0, 1e-12);
    EXPECT_NEAR(offsets[1], -0.3, 1e-12);
    EXPECT_NEAR(offsets[0] + offsets[3], 0.0, 1e-12);
    EXPECT_NEAR(offsets[1] + offsets[2], 0.0, 1e-12);
    // Largest input: 1 - 0.8 of the muscle.
    EXPECT_NEAR(number(probes_of("actuation_hysteresis", search)[0].columns[0], "width"), 0.1 * 0.2, 1e-15);
    EXPECT_NEAR(number(probes_of("stress_softening", search)[1].columns[0], "energy_scale_J_m3"), 30.0, 1e-12);
    // Vibrations are sought at three lines of the residual, without any at two cycles per trial.
    search.residual_lines_Hz = {7.0, 3.0, 11.0, 5.0};
    const std::vector<EffectProbe> lines = probes_of("base_vibration", search);
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_EQ(number(lines[2].columns[0], "frequency_Hz"), 11.0);
    search.residual_lines_Hz.clear();
    EXPECT_NEAR(number(probes_of("base_vibration", search).at(0).columns[0], "frequency_Hz"), 2.0 / 0.1, 1e-12);
    // A body at rest tells nothing of them.
    for (TrialContext& trial : search.trials) trial.hold = true;
    EXPECT_TRUE(probes_of("base_vibration", search).empty());
}

TEST(JoinedProbes, OfTiltsAddLikeVectors) {
    EffectSearch search = full_search();
    search.models[0].gravity_m_s2 = {1.0, -2.0, -9.0};
    const std::vector<EffectProbe> probes = probes_of("gravity_tilt", search);
    ASSERT_EQ(probes.size(), 1u);
    const std::vector<EffectParameters>& columns = probes[0].columns;
    ASSERT_EQ(columns.size(), 2u);
    const Vector3d first = vector(columns[0], "axis"), second = vector(columns[1], "axis");
    EXPECT_NEAR(first.dot(second), 0.0, 1e-15);
    EXPECT_NEAR(first.dot(search.models[0].gravity_m_s2), 0.0, 1e-14);
    EXPECT_NEAR(second.dot(search.models[0].gravity_m_s2), 0.0, 1e-14);
    const EffectParameters both = probes[0].joined(columns, Eigen::Vector2d(3.0, -4.0));
    EXPECT_NEAR(number(both, "tilt_deg"), 5.0, 1e-12);
    EXPECT_LT((vector(both, "axis") - (0.6 * first - 0.8 * second)).norm(), 1e-14);
    const EffectParameters none = probes[0].joined(columns, Eigen::Vector2d::Zero());
    EXPECT_EQ(number(none, "tilt_deg"), 0.01);
    EXPECT_EQ(vector(none, "axis"), first);
}

TEST(JoinedProbes, OfShiftsAndPosesAddLikeVectors) {
    EffectSearch search = full_search();
    const std::vector<EffectProbe> markers = probes_of("marker_offset", search);
    ASSERT_EQ(markers.size(), 2u) << "one per marker";
    const EffectParameters shifted = markers[1].joined(markers[1].columns, Vector3d(1.0, -2.0, 0.5));
    EXPECT_EQ(text(shifted, "marker"), "side");
    EXPECT_LT((vector(shifted, "shift_m") - Vector3d(1e-3, -2e-3, 5e-4)).norm(), 1e-17);
    search.trials[0].start = dynamics::StartKind::equilibrium;
    const std::vector<EffectProbe> poses = probes_of("held_pose", search);
    ASSERT_EQ(poses.size(), 1u) << "trials that start straight";
    ASSERT_EQ(poses[0].columns.size(), 2u) << "both directions across";
    const EffectParameters pose = poses[0].joined(poses[0].columns, Eigen::Vector2d(2.0, 3.0));
    EXPECT_LT((vector(pose, "offset_m") - Vector3d(0.0, 2e-3, 3e-3)).norm(), 1e-17);
    EXPECT_EQ(text(pose, "trial"), "drop again");
}

/// Without an amount the start is small but not absent, where a fit over decades could not begin.
TEST(JoinedProbes, OfNothingAreSmall) {
    const EffectSearch search = full_search();
    const EffectProbe vibration = probes_of("base_vibration", search)[0], tug = probes_of("cable_tug", search)[0];
    const EffectParameters still = vibration.joined(
        vibration.columns, VectorXd::Zero(static_cast<Eigen::Index>(vibration.columns.size())));
    EXPECT_NEAR(number(still, "amplitude_m"), 0.01 * number(vibration.columns[0], "amplitude_m"), 1e-18);
    EXPECT_NEAR(vector(still, "direction").norm(), 1.0, 1e-12);
    const EffectParameters pushed = tug.joined(tug.columns, VectorXd::Constant(6, -1.0));
    EXPECT_NEAR(number(pushed, "stiffness_N_m"), 0.1 * number(tug.columns[0], "stiffness_N_m"), 1e-15)
        << "no spring has a negative tensor";
}

/// Forms in which estimates are compared: a line has no sense, a tilt is angle times axis.
TEST(ComparableForms, AreEqualWhereTheEffectIs) {
    const Effect &vibration = *find_effect("base_vibration"), &tilt = *find_effect("gravity_tilt");
    const double pi = std::numbers::pi;
    const EffectParameters there{
        {"amplitude_m", 1e-3}, {"frequency_Hz", 5.0}, {"direction", three(0.0, 0.6, 0.8)}, {"phase_rad", 0.3}},
        back{{"amplitude_m", 1e-3},
             {"frequency_Hz", 5.0},
             {"direction", three(0.0, -6.0, -8.0)},
             {"phase_rad", 0.3 + 5.0 * pi}};
    const EffectParameters one = vibration.comparable(there), other = vibration.comparable(back);
    EXPECT_FALSE(has(one, "phase_rad")) << "phases differ between trials";
    EXPECT_LT((vector(one, "direction") - vector(other, "direction")).norm(), 1e-15);
    const model::Model any;
    EXPECT_NEAR(number(vibration.canonical(any, back), "phase_rad"), 0.3, 1e-13);
    EXPECT_NEAR(number(vibration.canonical(any, there), "phase_rad"), 0.3, 1e-15);
    EffectParameters without = back;
    without.erase("phase_rad");
    EXPECT_NEAR(std::abs(number(vibration.canonical(any, without), "phase_rad")), pi, 1e-15) << "half a turn of none";
    EXPECT_LT((vector(tilt.comparable({{"tilt_deg", -5.0}, {"axis", three(0.0, -3.0, 4.0)}}), "tilt_deg") -
               vector(tilt.comparable({{"tilt_deg", 5.0}, {"axis", three(0.0, 0.6, -0.8)}}), "tilt_deg"))
                  .norm(),
              1e-14);
    EXPECT_NEAR(number(tilt.comparable({{"tilt_deg", -5.0}, {"axis", three(0.0, -3.0, 4.0)}}), "tilt_deg"), 5.0, 1e-14);
}

}  // namespace
}  // namespace myo::effect::probes_tests
