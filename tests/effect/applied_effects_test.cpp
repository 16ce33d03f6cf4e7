#include <gtest/gtest.h>

#include <Eigen/Core>

#include <limits>
#include <string>
#include <vector>

#include "measurement/marker_binding.hpp"
#include "mesh/closest_point.hpp"
#include "model/directional_mass.hpp"
#include "model/elastic_bed.hpp"
#include "trial_context.hpp"

namespace myo::effect::applied_effects_tests {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

VectorXd at(double x, double y, double z) { return Vector3d(x, y, z); }

/// The beam with these effects, in the order in which they are declared.
Affected with(const test::HeldBeam& beam, const std::vector<EffectDeclaration>& effects) {
    Affected affected = beam.affected;
    apply_effects(beam.context, effects, affected);
    return affected;
}

/// Effects of one kind that are declared twice add up.
TEST(AppliedEffects, AddUpWhereTheyAreDeclaredTwice) {
    const test::HeldBeam beam = test::held_beam({6, 1, 1});
    const Affected twice = with(beam, {{"clock_offset", {{"offset_s", 0.01}}},
                                       {"scale_error", {{"relative_error", 0.02}}},
                                       {"frame_rate_error", {{"relative_error", -0.01}}},
                                       {"extra_damping", {{"excess_damping_s", 0.004}}},
                                       {"clock_offset", {{"offset_s", -0.03}}},
                                       {"scale_error", {{"relative_error", 0.005}}},
                                       {"frame_rate_error", {{"relative_error", 0.04}}},
                                       {"extra_damping", {{"excess_damping_s", 0.002}}}});
    EXPECT_NEAR(twice.observation_error.clock_offset_s, -0.02, 1e-16);
    EXPECT_NEAR(twice.observation_error.scale_error, 0.025, 1e-16);
    EXPECT_NEAR(twice.observation_error.rate_error, 0.03, 1e-16);
    EXPECT_NEAR(twice.model.damping_s, beam.affected.model.damping_s + 0.006, 1e-16);
    EXPECT_EQ(beam.affected.observation_error.clock_offset_s, 0.0) << "what was given is left";
}

/// Factors of the stiffness multiply at every point, and none falls below a hundredth.
TEST(AppliedEffects, MultiplyTheStiffnessAndKeepItPositive) {
    const test::HeldBeam beam = test::held_beam({6, 1, 1});
    const EffectDeclaration graded{"stiffness_gradient", {{"relative_change", 0.8}, {"axis", 0.0}}},
        across{"stiffness_gradient", {{"relative_change", -0.4}, {"axis", 2.0}}},
        hole{"soft_patch", {{"relative_change", -3.0}, {"centre_m", at(0.06, 0.015, 0.015)}, {"radius_m", 10.0}}};
    const VectorXd both = with(beam, {graded, across}).model.point_factors,
                   one = with(beam, {graded}).model.point_factors, two = with(beam, {across}).model.point_factors;
    ASSERT_GT(both.size(), 0);
    EXPECT_LT((both - one.cwiseProduct(two)).norm(), 1e-13);
    EXPECT_GT((both - one).norm(), 0.1);
    const VectorXd soft = with(beam, {hole}).model.point_factors;
    EXPECT_LT((soft - VectorXd::Constant(soft.size(), 0.01)).norm(), 1e-15);
    // The drift of a session, too, leaves a hundredth.
    const Affected fallen = with(beam, {{"modulus_drift", {{"rate_1_s", -0.5}}}});
    EXPECT_NEAR(fallen.model.moduli[0].mu, 0.01 * beam.affected.model.moduli[0].mu, 1e-9);
    EXPECT_NEAR(fallen.model.moduli[0].kappa, 0.01 * beam.affected.model.moduli[0].kappa, 1e-7);
}

TEST(AppliedEffects, OfNoAmountCostNoState) {
    const test::HeldBeam beam = test::held_beam({6, 1, 1});
    const EffectParameters creep{{"modulus_ratio", 0.0}, {"relaxation_time_s", 0.2}},
        damage{{"damage_max", 0.0}, {"energy_scale_J_m3", 20.0}};
    EXPECT_FALSE(with(beam, {{"viscoelastic_creep", creep}}).model.creep.has_value());
    EXPECT_FALSE(with(beam, {{"stress_softening", damage}}).model.softening.has_value());
    const Affected creeping = with(beam,
                                   {{"viscoelastic_creep", {{"modulus_ratio", 0.4}, {"relaxation_time_s", 0.2}}}});
    ASSERT_TRUE(creeping.model.creep.has_value());
    EXPECT_EQ(creeping.model.creep->modulus_ratio, 0.4);
    EXPECT_EQ(creeping.model.creep->relaxation_time_s, 0.2);
    for (const char* id : {"actuation_lag", "actuation_delay"}) {
        const std::string key = std::string(id) == "actuation_lag" ? "time_constant_s" : "delay_s";
        EXPECT_EQ(with(beam, {{id, {{key, 0.0}}}}).model.activation, beam.affected.model.activation) << id;
    }
}

/// Markers that are not on the body are ignored; the exchange and the slip name those that are by their number.
TEST(AppliedEffects, OfMarkersGoByTheirNumber) {
    test::HeldBeam beam = test::held_beam({6, 1, 1});
    const mesh::BoundaryLocator boundary(beam.context.body->mesh);
    for (const Vector3d& place : beam.context.marker_rest_m)
        beam.context.markers.push_back(measurement::bind_marker(beam.context.body->mesh, boundary, place));
    using Names = std::vector<std::string>;
    const auto error = [&](const std::string& id, const EffectParameters& parameters) {
        return with(beam, {{id, parameters}}).observation_error;
    };
    EXPECT_TRUE(error("marker_swap", {{"markers", Names{"tip", "wall"}}, {"time_s", 1.0}}).swaps.empty());
    EXPECT_TRUE(error("marker_slip", {{"marker", std::string("wall")}, {"shift_m", at(1, 0, 0)}, {"time_s", 1.0}})
                    .shifts.empty());
    EXPECT_TRUE(error("marker_offset", {{"marker", std::string("wall")}, {"shift_m", at(1, 0, 0)}}).places.empty());
    const auto swapped = error("marker_swap", {{"markers", Names{"side", "tip"}}, {"time_s", 1.5}}).swaps;
    ASSERT_EQ(swapped.size(), 1u);
    EXPECT_TRUE(swapped[0].first == 1 && swapped[0].second == 0 && swapped[0].from_s == 1.5);
    const auto slipped = error("marker_slip",
                               {{"marker", std::string("side")}, {"shift_m", at(1e-3, 0, 2e-3)}, {"time_s", 0.5}})
                             .shifts;
    ASSERT_EQ(slipped.size(), 1u);
    EXPECT_TRUE(slipped[0].marker == 1 && slipped[0].from_s == 0.5);
    EXPECT_EQ(slipped[0].shift_m, Vector3d(1e-3, 0.0, 2e-3));
    // Two offsets of one marker are one place with their sum.
    const EffectDeclaration right{"marker_offset", {{"marker", std::string("side")}, {"shift_m", at(1e-3, 0, 0)}}},
        up{"marker_offset", {{"marker", std::string("side")}, {"shift_m", at(0, 0, 2e-3)}}},
        other{"marker_offset", {{"marker", std::string("tip")}, {"shift_m", at(0, 1e-3, 0)}}};
    const auto places = with(beam, {right, other, up}).observation_error.places;
    ASSERT_EQ(places.size(), 2u);
    EXPECT_TRUE(places[0].marker == 1 && places[1].marker == 0);
    EXPECT_LT((places[0].shift_m - Vector3d(1e-3, 0.0, 2e-3)).norm(), 1e-18);
    EXPECT_EQ(places[1].shift_m, Vector3d(0.0, 1e-3, 0.0));
}

/// A hung body has the mass whose weight the force is, along it and while it hangs.
TEST(AppliedEffects, HungBodiesAreThoseThatHangDuringTheRun) {
    test::HeldBeam beam = test::held_beam({6, 1, 1});
    const double endless = std::numeric_limits<double>::infinity();
    const VectorXd tip = test::tip_share(beam.affected.model, beam.spec);
    model::DeadForce hanging{tip, Vector3d(0.0, 0.3, -0.4)}, released = hanging, late = hanging, none = hanging,
                                                             growing = hanging, passing = hanging;
    released.until_s = 0.0;
    late.from_s = 0.1;  // the end of the run
    none.force_N.setZero();
    growing.course = fibre::Signal{{0.0, 1.0}, {0.0, 1.0}};
    passing.from_s = 0.05;
    passing.until_s = 0.3;
    beam.affected.model.forces = {hanging, released, late, none, growing, passing};
    const auto masses = [&](double gravity) {
        beam.affected.model.gravity_m_s2 = {0.0, 0.0, -gravity};
        return with(beam, {{"hung_mass", {{"inertia_ratio", 2.0}}}}).model.directional_masses;
    };
    const auto bodies = masses(10.0);
    ASSERT_EQ(bodies.size(), 2u);
    EXPECT_EQ(bodies[0].from_s, -endless);
    EXPECT_EQ(bodies[1].from_s, 0.05);
    EXPECT_EQ(bodies[1].until_s, 0.3);
    // Trace of the inertia: ratio times force over gravity.
    EXPECT_NEAR(Eigen::MatrixXd(bodies[0].inertia_kg).trace(), 2.0 * 0.5 / 10.0, 1e-15);
    EXPECT_NEAR(Eigen::MatrixXd(masses(0.0)[0].inertia_kg).trace(), 2.0 * 0.5 / 9.80665, 1e-15)
        << "standard gravity where the model has none";
}

TEST(AppliedEffects, VibrateByThePhaseOfTheirTrial) {
    test::HeldBeam beam = test::held_beam({6, 1, 1});
    const auto phase = [&](std::size_t trial, const EffectParameter& phases) {
        beam.context.number = trial;
        const Affected shaken = with(beam, {{"base_vibration",
                                             {{"amplitude_m", 2e-3},
                                              {"frequency_Hz", 8.0},
                                              {"direction", at(0.0, 3.0, 4.0)},
                                              {"phase_rad", phases}}}});
        EXPECT_EQ(shaken.mount_vibrations.size(), 1u);
        EXPECT_LT((shaken.mount_vibrations.at(0).amplitude_m - Vector3d(0.0, 1.2e-3, 1.6e-3)).norm(), 1e-17);
        return shaken.mount_vibrations.at(0).phase_rad;
    };
    const VectorXd list = Vector3d(0.1, 0.2, 0.3);
    EXPECT_EQ(phase(0, list), 0.1);
    EXPECT_EQ(phase(2, list), 0.3);
    EXPECT_EQ(phase(3, list), 0.1) << "the first for trials beyond the list";
    EXPECT_EQ(phase(1, VectorXd()), 0.0);
    EXPECT_EQ(phase(1, 0.7), 0.7);
    beam.context.hold = true;
    const Affected resting = with(
        beam, {{"base_vibration", {{"amplitude_m", 2e-3}, {"frequency_Hz", 8.0}, {"direction", at(0, 0, 1)}}}});
    EXPECT_TRUE(resting.mount_vibrations.empty()) << "a hold is at rest";
}

/// On a moving mount forces from outside are seen from it, what joins the body to it is not, and inertia comes last.
TEST(AppliedEffects, PutTheBodyOnItsMount) {
    const test::HeldBeam beam = test::held_beam({6, 1, 1});
    const EffectDeclaration bed{"clamp_compliance", {{"stiffness_Pa_per_m", 1e7}}},
        drag{"linear_drag", {{"coefficient_Pa_s_m", 50.0}}},
        shaking{"base_vibration", {{"amplitude_m", 2e-3}, {"frequency_Hz", 8.0}, {"direction", at(0, 0, 1)}}};
    const Affected still = with(beam, {bed, drag}), moving = with(beam, {shaking, bed, drag});
    ASSERT_EQ(still.model.force_elements.size(), 2u);
    EXPECT_FALSE(still.observation_error.mount);
    EXPECT_TRUE(is_elastic_bed(*still.model.force_elements[1])) << "forces come before supports";
    ASSERT_EQ(moving.model.force_elements.size(), 3u);
    ASSERT_TRUE(moving.observation_error.mount);
    EXPECT_FALSE(moving.model.force_elements[0]->steady(0.0, 1.0)) << "drag as it is seen from the mount";
    EXPECT_TRUE(still.model.force_elements[0]->steady(0.0, 1.0));
    EXPECT_TRUE(is_elastic_bed(*moving.model.force_elements[1])) << "the bed moves with the mount";
    EXPECT_EQ(moving.model.force_elements[2]->parameters().at(0).name, "density_kg_m3");
    EXPECT_NEAR(moving.observation_error.mount->at(1.0 / 32.0).place_m.z(), 2e-3, 1e-15);
}

}  // namespace
}  // namespace myo::effect::applied_effects_tests
