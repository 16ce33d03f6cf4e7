#include <gtest/gtest.h>

#include <set>

#include "dynamics/simulate.hpp"
#include "trial_context.hpp"

namespace myo::effect {
namespace {

/// Parameters of every effect at which it can be seen on the held beam.
std::map<std::string, EffectParameters> visible_effects() {
    const auto at = [](double x, double y, double z) { return Eigen::VectorXd(Eigen::Vector3d(x, y, z)); };
    return {
        {"quadratic_drag", {{"coefficient_kg_m3", 800.0}}},
        {"linear_drag", {{"coefficient_Pa_s_m", 50.0}}},
        {"added_mass", {{"surface_density_kg_m2", 2.0}}},
        {"point_mass", {{"mass_kg", 0.005}, {"position_m", at(0.12, 0.015, 0.03)}}},
        {"cable_tug",
         {{"stiffness_N_m", 5.0}, {"position_m", at(0.12, 0.015, 0.03)}, {"anchor_m", at(0.12, 0.015, 0.2)}}},
        {"dry_friction",
         {{"friction_force_N", 0.01}, {"position_m", at(0.12, 0.015, 0.03)}, {"normal", at(0.0, 1.0, 0.0)}}},
        {"end_stop",
         {{"stiffness_N_m", 50.0},
          {"gap_m", 1e-4},
          {"position_m", at(0.12, 0.015, 0.03)},
          {"normal", at(0.0, 0.0, 1.0)}}},
        {"hung_mass", {{"inertia_ratio", 1.0}}},
        {"gravity_tilt", {{"tilt_deg", 5.0}, {"axis", at(1.0, 0.0, 0.0)}}},
        {"base_vibration",
         {{"amplitude_m", 2e-3}, {"frequency_Hz", 8.0}, {"direction", at(0.0, 0.6, 0.8)}, {"phase_rad", 0.5}}},
        {"clamp_compliance", {{"stiffness_Pa_per_m", 1e7}}},
        {"clamp_slip", {{"free_length_m", 0.012}}},
        {"held_pose", {{"offset_m", at(0.0, 0.004, 0.0)}}},
        {"extra_damping", {{"excess_damping_s", 0.01}}},
        {"viscoelastic_creep", {{"modulus_ratio", 0.5}, {"relaxation_time_s", 0.1}}},
        {"strain_stiffening", {{"yeoh_c2", 2.0}}},
        {"stress_softening", {{"damage_max", 0.3}, {"energy_scale_J_m3", 20.0}}},
        {"stiffness_gradient", {{"relative_change", 0.5}, {"axis", 0.0}}},
        {"soft_patch", {{"relative_change", -0.5}, {"centre_m", at(0.04, 0.015, 0.015)}, {"radius_m", 0.01}}},
        {"modulus_drift", {{"rate_1_s", 1e-3}}},
        {"intrinsic_curvature", {{"curvature_1_m", 2.0}, {"axis", 2.0}}},
        {"actuation_lag", {{"time_constant_s", 0.03}}},
        {"actuation_delay", {{"delay_s", 0.03}}},
        {"actuation_gain", {{"relative_change", 0.3}}},
        {"actuation_leak", {{"time_constant_s", 0.05}}},
        {"actuation_hysteresis", {{"fraction", 0.5}, {"width", 0.1}}},
    };
}

/// What changes only what is seen.
const std::set<std::string> seen_alone{"clock_offset", "frame_rate_error", "scale_error",
                                       "marker_swap",  "marker_offset",    "marker_slip"};

/// What a body without tendons does not show; tested with one in tests/prediction.
const std::set<std::string> of_tendons{"tendon_friction", "tendon_channel"};

TEST(EffectCatalogue, NamesAreUniqueAndEntriesComplete) {
    EXPECT_EQ(effect_catalogue().size(), 34u);
    for (const Effect& effect : effect_catalogue()) {
        EXPECT_EQ(find_effect(effect.id), &effect);
        EXPECT_FALSE(effect.parameters.empty()) << effect.id;
        EXPECT_FALSE(effect.summary.empty()) << effect.id;
        EXPECT_NE(effect.apply, nullptr) << effect.id;
        EXPECT_EQ(effect.kind == EffectKind::measurement, seen_alone.count(effect.id) == 1) << effect.id;
        EXPECT_TRUE(seen_alone.count(effect.id) + of_tendons.count(effect.id) + visible_effects().count(effect.id) == 1)
            << effect.id << " is not tested below";
    }
    EXPECT_EQ(find_effect("none"), nullptr);
}

/// A fit may end at an axis that leans along gravity, with a larger angle for it: the smallest turn that does the same
/// is told.
TEST(GravityTilt, IsToldAsTheSmallestTurnThatDoesTheSame) {
    const test::HeldBeam beam = test::held_beam({6, 2, 2});
    const Effect& tilt = *find_effect("gravity_tilt");
    Affected declared = beam.affected;
    declared.model.gravity_m_s2 = {0.3, 0.0, -9.8};
    for (const Eigen::Vector3d& axis :
         {Eigen::Vector3d(0.755, 0.036, -0.655), Eigen::Vector3d(-2.0, 1.0, 0.5), Eigen::Vector3d(1.0, 0.0, 0.0306)}) {
        const EffectParameters fitted{{"tilt_deg", 5.3}, {"axis", Eigen::VectorXd(axis)}},
            plain = tilt.canonical(declared.model, fitted);
        Affected once = declared, again = declared;
        tilt.apply(beam.context, fitted, once);
        tilt.apply(beam.context, plain, again);
        EXPECT_NEAR((once.model.gravity_m_s2 - again.model.gravity_m_s2).norm(), 0.0, 1e-12);
        EXPECT_GT((once.model.gravity_m_s2 - declared.model.gravity_m_s2).norm(), 0.1);
        EXPECT_NEAR(vector(plain, "axis").norm(), 1.0, 1e-12);
        EXPECT_NEAR(vector(plain, "axis").dot(declared.model.gravity_m_s2), 0.0, 1e-12);
        EXPECT_LE(std::abs(number(plain, "tilt_deg")), 5.3 + 1e-12);
    }
    EXPECT_LT(number(tilt.canonical(declared.model, {{"tilt_deg", 5.3},
                                                     {"axis", Eigen::VectorXd(Eigen::Vector3d(0.755, 0.0, -0.655))}}),
                     "tilt_deg"),
              4.2);
    EXPECT_NEAR(
        number(tilt.canonical(declared.model, {{"tilt_deg", 0.0}, {"axis", Eigen::VectorXd(Eigen::Vector3d::UnitX())}}),
               "tilt_deg"),
        0.0, 1e-12);
}

/// What a slanted spring does to first order, as a sum of a probe's springs, leads back to it.
TEST(CableTug, IsSoughtAlongTheSpringWhoseTensorTheColumnsAddUpTo) {
    const test::HeldBeam beam = test::held_beam({6, 2, 2});
    EffectSearch search;
    search.trials = {beam.context};
    const Eigen::Vector3d d = Eigen::Vector3d(0.6, -0.3, 0.74).normalized();
    const auto tensor = [](const Eigen::Vector3d& along) {
        const Eigen::Matrix3d t = along * along.transpose();
        return Eigen::Vector<double, 6>(t(0, 0), t(1, 1), t(2, 2), t(0, 1), t(1, 2), t(2, 0));
    };
    for (const EffectProbe& probe : find_effect("cable_tug")->probes(search)) {
        ASSERT_EQ(probe.columns.size(), 6u);
        Eigen::Matrix<double, 6, 6> basis;
        for (int i = 0; i < 6; ++i) {
            const EffectParameters& column = probe.columns[static_cast<std::size_t>(i)];
            basis.col(i) = tensor((vector(column, "anchor_m") - vector(column, "position_m")).normalized());
        }
        const EffectParameters found = probe.joined(probe.columns, basis.partialPivLu().solve(5.0 * tensor(d)));
        EXPECT_NEAR(number(found, "stiffness_N_m"), 5.0 * number(probe.columns[0], "stiffness_N_m"), 1e-9);
        const Eigen::Vector3d along = (vector(found, "anchor_m") - vector(found, "position_m")).normalized();
        EXPECT_NEAR(std::abs(along.dot(d)), 1.0, 1e-9);
    }
}

/// Six columns of a vibration along a line lead back to it; with several trials each has its phase.
TEST(BaseVibration, IsSoughtAlongTheLineThatTheColumnsAddUpTo) {
    const test::HeldBeam beam = test::held_beam({6, 2, 2});
    const Effect& vibration = *find_effect("base_vibration");
    const Eigen::Vector3d d = Eigen::Vector3d(0.2, -0.5, 0.9).normalized();
    EffectSearch search;
    search.residual_lines_Hz = {7.3, 12.0};
    for (std::size_t trials = 1; trials <= 2; ++trials) {
        search.trials.push_back(beam.context);
        search.trials.back().number = 2 * (trials - 1);
        search.trials.back().trial = trials == 1 ? "drop" : "drop again";
        const std::vector<EffectProbe> probes = vibration.probes(search);
        ASSERT_EQ(probes.size(), 2u);
        ASSERT_EQ(probes[0].columns.size(), 6 * trials);
        // Amplitudes of sine and cosine for 3 mm with phases 0.4 and -2 rad.
        Eigen::VectorXd multiples(6 * static_cast<Eigen::Index>(trials));
        for (std::size_t i = 0; i < probes[0].columns.size(); ++i) {
            const EffectParameters& column = probes[0].columns[i];
            const double phase = i < 6 ? 0.4 : -2.0, along = d.dot(vector(column, "direction"));
            const Eigen::VectorXd own = std::get<Eigen::VectorXd>(column.at("phase_rad"));
            EXPECT_EQ(own.size(), i < 6 ? 1 : 3);
            multiples(static_cast<Eigen::Index>(i)) = 3e-3 / number(column, "amplitude_m") * along *
                                                      (own(own.size() - 1) == 0.0 ? std::cos(phase) : std::sin(phase));
        }
        const EffectParameters found = vibration.canonical(beam.affected.model,
                                                           probes[0].joined(probes[0].columns, multiples));
        EXPECT_NEAR(number(found, "amplitude_m"), 3e-3, 1e-12);
        EXPECT_EQ(number(found, "frequency_Hz"), 7.3);
        EXPECT_LT((vector(found, "direction") - d).norm(), 1e-9);
        if (trials == 1) {
            EXPECT_NEAR(number(found, "phase_rad"), 0.4, 1e-9);
        } else {
            const Eigen::VectorXd phases = std::get<Eigen::VectorXd>(found.at("phase_rad"));
            EXPECT_NEAR(phases(0), 0.4, 1e-9);
            EXPECT_NEAR(phases(2), -2.0, 1e-9);
        }
    }
    // The other way along the line is half a turn of the phase.
    const EffectParameters turned = vibration.canonical(beam.affected.model,
                                                        {{"amplitude_m", 1e-3},
                                                         {"frequency_Hz", 5.0},
                                                         {"direction", Eigen::VectorXd(-d)},
                                                         {"phase_rad", 0.4 - 3.14159265358979323846}});
    EXPECT_LT((vector(turned, "direction") - d).norm(), 1e-9);
    EXPECT_NEAR(number(turned, "phase_rad"), 0.4, 1e-9);
}

class MovingEffect : public ::testing::TestWithParam<std::pair<const std::string, EffectParameters>> {};

TEST_P(MovingEffect, ChangesTheMotionAndLeavesWhatItIsGiven) {
    const test::HeldBeam beam = test::held_beam({6, 2, 2});
    const dynamics::Trace without = dynamics::simulate(beam.affected.model, beam.affected.options);
    ASSERT_TRUE(without.complete()) << without.message;
    const Affected affected = test::with_effect(beam, GetParam().first, GetParam().second);
    const dynamics::Trace with = dynamics::simulate(affected.model, affected.options);
    ASSERT_TRUE(with.complete()) << with.message;
    EXPECT_GT((with.positions.back() - without.positions.back()).cwiseAbs().maxCoeff(), 2e-5);
    const dynamics::Trace again = dynamics::simulate(beam.affected.model, beam.affected.options);
    EXPECT_EQ(again.positions.back(), without.positions.back());
    // A trial that is not its own is left alone.
    EffectParameters elsewhere = GetParam().second;
    elsewhere["trial"] = std::string("another");
    Affected alone = beam.affected;
    apply_effects(beam.context, {{GetParam().first, elsewhere}}, alone);
    EXPECT_EQ(dynamics::simulate(alone.model, alone.options).positions.back(), without.positions.back());
}

/// The finer element is chosen by this mark.
TEST_P(MovingEffect, IsMarkedWhereItVariesWithinCells) {
    const test::HeldBeam beam = test::held_beam({6, 2, 2});
    const Affected affected = test::with_effect(beam, GetParam().first, GetParam().second);
    const bool varies = affected.model.point_factors.size() > 0 || affected.model.softening.has_value() ||
                        affected.model.material != beam.affected.model.material;
    EXPECT_EQ(any_varies_within_cells({{GetParam().first, GetParam().second}}), varies);
}

/// What a search starts from can be simulated, and a small amount changes little: absence is a limit.
TEST_P(MovingEffect, IsContinuousAtItsAbsence) {
    const test::HeldBeam beam = test::held_beam({6, 2, 2});
    const Effect& effect = *find_effect(GetParam().first);
    EffectSearch search;
    search.trials = {beam.context};
    search.trials.push_back(beam.context);
    search.trials.back().session_time_s = 400.0;
    search.models = {beam.affected.model, beam.affected.model};
    search.largest_energy_density_J_m3 = 100.0;
    const std::vector<EffectProbe> probes = effect.probes(search);
    ASSERT_FALSE(probes.empty());
    const Eigen::Matrix3Xd without = dynamics::simulate(beam.affected.model, beam.affected.options).positions.back();
    const auto change = [&](const EffectParameters& parameters) {
        const Affected affected = test::with_effect(beam, effect.id, parameters);
        const dynamics::Trace run = dynamics::simulate(affected.model, affected.options);
        EXPECT_TRUE(run.complete()) << run.message;
        return run.complete() ? (run.positions.back() - without).norm() : 0.0;
    };
    const EffectParameters& large = probes.front().columns.front();
    const double of_large = change(large);
    EXPECT_GT(of_large, 0.0);
    if (probes.front().amount.empty()) return;
    EffectParameters small = large;
    const double amount = number(large, probes.front().amount);
    small[probes.front().amount] = probes.front().reciprocal ? 10.0 * amount : 0.1 * amount;
    EXPECT_LT(change(small), 0.5 * of_large);
}

INSTANTIATE_TEST_SUITE_P(OfTheCatalogue, MovingEffect, ::testing::ValuesIn(visible_effects()),
                         [](const auto& given) { return given.param.first; });

}  // namespace
}  // namespace myo::effect
