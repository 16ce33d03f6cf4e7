#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/stage_solver.hpp"
#include "dynamics/statics.hpp"
#include "effect/places.hpp"
#include "effect_site.hpp"
#include "measurement/observe.hpp"

namespace myo {
namespace {

Eigen::Matrix3Xd at_rest(const Model& model) {
    StageSolver solver(model);
    Eigen::Matrix3Xd x = model.body->mesh.nodes;
    const StageReport report = solve_equilibrium(solver, 0.0, x);
    EXPECT_TRUE(report.ok()) << report.message;
    return x;
}

double tip_z(const test::HeldBeam& beam, const Model& model) { return test::tip_displacement(model, beam.spec, at_rest(model)).z(); }

/// Nothing but what the effect does.
test::HeldBeam unloaded() {
    test::HeldBeam beam = test::held_beam({12, 2, 4});
    beam.affected.model.gravity_m_s2.setZero();
    beam.affected.model.forces.clear();
    beam.affected.model.fibres = std::make_shared<std::vector<FibreGroup>>();
    beam.affected.model.activation.clear();
    return beam;
}

TEST(EffectForms, AnIntrinsicCurvatureBendsTheFreePartIntoItsArc) {
    const test::HeldBeam beam = unloaded();
    const double k = 1.0, L = 0.1;
    const Affected bent = test::with_effect(beam, "intrinsic_curvature", {{"curvature_1_m", k}, {"axis", 2.0}});
    // Fibres above are longer: the beam bends down. The clamp holds the section of the first cells, which takes a little of it.
    EXPECT_NEAR(tip_z(beam, bent.model), -(1.0 - std::cos(k * L)) / k, 0.04 * 0.5 * k * L * L);
}

TEST(EffectForms, ACompliantClampTurnsAndShiftsTheBeam) {
    test::HeldBeam beam = unloaded();
    // Held at the face alone, so that the bed is the face.
    beam.affected.model.body = test::make_beam(beam.spec).body;
    beam.site.body = beam.affected.model.body;
    const double F = 1e-3, k = 2e7, L = 0.12, area = 9e-4, second_moment = 0.03 * std::pow(0.03, 3) / 12.0;
    beam.affected.model.forces.push_back({test::tip_share(beam.affected.model, beam.spec), Eigen::Vector3d(0.0, 0.0, F)});
    const Affected soft = test::with_effect(beam, "clamp_compliance", {{"stiffness_Pa_per_m", k}});
    const double more = tip_z(beam, soft.model) - tip_z(beam, beam.affected.model);
    // A rigid plate on the bed; the end face warps a little besides.
    const double expected = F / (k * area) + F * L * L / (k * second_moment);
    EXPECT_NEAR(more, expected, 0.1 * expected);
}

TEST(EffectForms, ASlippingClampFreesAsMuchLength) {
    test::HeldBeam beam = unloaded();
    beam.affected.model.forces.push_back({test::tip_share(beam.affected.model, beam.spec), Eigen::Vector3d(0.0, 0.0, 1e-3)});
    const double declared = tip_z(beam, beam.affected.model);
    // Half of the clamp's two cells, where a mesh can say the same exactly.
    const Affected slipped = test::with_effect(beam, "clamp_slip", {{"free_length_m", 0.01}});
    Model shorter = beam.affected.model;
    shorter.body = make_body(shorter.body->mesh, beam.spec.kind, nodes_in_box(shorter.body->mesh, {{-1.0, -1.0, -1.0}, {0.01 + 1e-9, 1.0, 1.0}}));
    const double expected = tip_z(beam, shorter);
    EXPECT_GT(expected, 1.2 * declared);
    EXPECT_NEAR(tip_z(beam, slipped.model), expected, 0.03 * (expected - declared));
    // Where a marker hangs on the cells in front of the clamp, these alone reach back.
    beam.site.markers = marker_set(beam.site.body->mesh, {{0.024, 0.015, 0.03}}).bindings;
    EXPECT_NEAR(tip_z(beam, test::with_effect(beam, "clamp_slip", {{"free_length_m", 0.01}}).model), expected, 0.1 * (expected - declared));
    beam.site.markers.clear();
    // Within a cell the deflection grows as that of ever longer cantilevers.
    const double L = 0.1;
    for (const double free_m : {0.0025, 0.005, 0.0075}) {
        const double part = (std::pow(L + free_m, 3) - std::pow(L, 3)) / (std::pow(L + 0.01, 3) - std::pow(L, 3));
        const Affected between = test::with_effect(beam, "clamp_slip", {{"free_length_m", free_m}});
        EXPECT_NEAR((tip_z(beam, between.model) - declared) / (expected - declared), part, 0.03) << free_m;
    }
}

/// The muscles reach as far as the cells in front of the clamp do, and nobody moved the markers there.
TEST(EffectForms, ASlippingClampLeavesMusclesAndMarkersAtRest) {
    test::HeldBeam beam = test::held_beam();
    const Eigen::Vector3d on_first_cell(0.024, 0.015, 0.03);
    beam.site.markers = marker_set(beam.site.body->mesh, {on_first_cell}).bindings;
    const double free_m = 0.006;
    const Affected slipped = test::with_effect(beam, "clamp_slip", {{"free_length_m", free_m}});
    const Body& body = *slipped.model.body;
    EXPECT_NEAR(cell_volumes(body.mesh).sum(), cell_volumes(beam.site.body->mesh).sum(), 1e-12);
    EXPECT_GT(cell_volumes(test::with_effect(beam, "clamp_slip", {{"free_length_m", 1.0}}).model.body->mesh).minCoeff(), 0.0);   // something stays held
    const Eigen::Matrix3d stretch = Eigen::Vector3d(1.2, 0.9, 1.0).asDiagonal();
    const Eigen::Matrix3Xd x = stretch * body.mesh.nodes;
    for (std::size_t g = 0; g < slipped.model.fibres->size(); ++g) {
        const FibreGroup& group = (*slipped.model.fibres)[g];
        EXPECT_NEAR(group.volume(), (*beam.affected.model.fibres)[g].volume() * (0.1 + free_m) / 0.1, 1e-12);
        for (const FibrePoint& point : group.points) EXPECT_LT((x(Eigen::all, body.mesh.cells.col(point.cell)) * point.shape - Eigen::Vector3d(1.2, 0.0, 0.0)).norm(), 1e-9);
    }
    const MarkerBinding& marker = beam.site.markers.front();
    std::vector<Eigen::Matrix3Xd> tracks{body.mesh.nodes(Eigen::all, marker.nodes) * marker.weights};
    EXPECT_GT((tracks[0] - on_first_cell).norm(), 0.1 * free_m);
    EXPECT_LT((seen_tracks(slipped.seen, tracks, Eigen::VectorXd::Zero(1))[0] - on_first_cell).norm(), 1e-12);
}

TEST(EffectForms, ASlippingClampAndACurvatureMakeALongerArcInEitherOrder) {
    const test::HeldBeam beam = unloaded();
    const EffectDeclaration slip{"clamp_slip", {{"free_length_m", 0.01}}, false}, curvature{"intrinsic_curvature", {{"curvature_1_m", 1.0}, {"axis", 2.0}}, false};
    for (const auto& effects : {std::vector{slip, curvature}, std::vector{curvature, slip}}) {
        Affected affected = beam.affected;
        apply_effects(beam.site, effects, affected);
        EXPECT_NEAR(tip_z(beam, affected.model), -(1.0 - std::cos(0.11)), 0.06 * 0.5 * 0.11 * 0.11);
    }
}

TEST(EffectForms, AHeldPoseStartsAtItsOffset) {
    const test::HeldBeam beam = test::held_beam();
    const Affected held = test::with_effect(beam, "held_pose", {{"offset_m", Eigen::VectorXd(Eigen::Vector3d(0.0, 0.003, -0.001))}});
    const Eigen::Vector3d tip = test::tip_displacement(held.model, beam.spec, held.options.initial.positions);
    EXPECT_NEAR((tip - Eigen::Vector3d(0.0, 0.003, -0.001)).norm(), 0.0, 1e-12);
}

TEST(EffectForms, StiffnessFollowsItsFormula) {
    const test::HeldBeam beam = test::held_beam();
    const Eigen::Matrix3Xd centres = cell_centres(*beam.site.body);
    const Affected graded = test::with_effect(beam, "stiffness_gradient", {{"relative_change", 0.4}, {"axis", 0.0}});
    const Affected drifted = test::with_effect(beam, "modulus_drift", {{"rate_1_s", 1e-3}});
    const Eigen::Vector3d centre(0.05, 0.015, 0.015);
    const Affected patched = test::with_effect(beam, "soft_patch", {{"relative_change", -0.5}, {"centre_m", Eigen::VectorXd(centre)}, {"radius_m", 0.02}});
    for (std::size_t c = 0; c < beam.affected.model.moduli.size(); ++c) {
        const Eigen::Vector3d X = centres.col(static_cast<Eigen::Index>(c));
        const double mu = beam.affected.model.moduli[c].mu;
        EXPECT_NEAR(graded.model.moduli[c].mu / mu, 1.0 + 0.4 * (X.x() / 0.12 - 0.5), 1e-9);
        EXPECT_NEAR(drifted.model.moduli[c].mu / mu, 1.1, 1e-9);
        EXPECT_NEAR(patched.model.moduli[c].kappa / beam.affected.model.moduli[c].kappa, 1.0 - 0.5 * std::exp(-(X - centre).squaredNorm() / 8e-4), 1e-9);
    }
}

TEST(EffectForms, PlacesOnTheSurfaceReproduceThePoint) {
    for (const ElementKind kind : {ElementKind::hex8, ElementKind::tet10}) {
        test::HeldBeam beam = test::held_beam({4, 1, 1});
        beam.spec.kind = kind;
        const BodyPointer body = test::make_beam(beam.spec).body;
        for (const Eigen::Vector3d& point : {Eigen::Vector3d(0.11, 0.012, 0.03), Eigen::Vector3d(0.12, 0.001, 0.029), Eigen::Vector3d(0.07, 0.0, 0.013)}) {
            const SurfacePlace place = surface_place(*body, point);
            EXPECT_GE(place.shares.minCoeff(), 0.0);
            EXPECT_NEAR(place.shares.sum(), 1.0, 1e-12);
            EXPECT_LT((body->mesh.nodes(Eigen::all, place.nodes) * place.shares - place.point).norm(), 1e-9);
        }
    }
}

}  // namespace
}  // namespace myo
