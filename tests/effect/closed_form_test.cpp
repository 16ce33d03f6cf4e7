#include <gtest/gtest.h>

#include <cmath>

#include "effect/places.hpp"
#include "model/rest_points.hpp"
#include "plain_body.hpp"

namespace myo::effect {
namespace {

double tip_z(const test::HeldBeam& beam, const model::Model& model) { return test::tip_at_rest(beam, model).z(); }

/// Nothing but what the effect does.
test::HeldBeam unloaded() {
    test::HeldBeam beam = test::held_beam({12, 2, 4});
    beam.affected.model.gravity_m_s2.setZero();
    beam.affected.model.forces.clear();
    beam.affected.model.fibres = std::make_shared<std::vector<fibre::FibreGroup>>();
    beam.affected.model.activation.clear();
    return beam;
}

TEST(EffectForms, AnIntrinsicCurvatureBendsTheFreePartIntoItsArc) {
    const test::HeldBeam beam = unloaded();
    const double k = 1.0, L = 0.1;
    const Affected bent = test::with_effect(beam, "intrinsic_curvature", {{"curvature_1_m", k}, {"axis", 2.0}});
    // Fibres above are longer: the beam bends down. The clamp holds the section of the first cells, which takes a
    // little of it.
    EXPECT_NEAR(tip_z(beam, bent.model), -(1.0 - std::cos(k * L)) / k, 0.04 * 0.5 * k * L * L);
}

TEST(EffectForms, ASlippingClampAndACurvatureMakeALongerArcInEitherOrder) {
    const test::HeldBeam beam = unloaded();
    const EffectDeclaration slip{"clamp_slip", {{"free_length_m", 0.01}}, false},
        curvature{"intrinsic_curvature", {{"curvature_1_m", 1.0}, {"axis", 2.0}}, false};
    for (const auto& effects : {std::vector{slip, curvature}, std::vector{curvature, slip}}) {
        Affected affected = beam.affected;
        apply_effects(beam.context, effects, affected);
        EXPECT_NEAR(tip_z(beam, affected.model), -(1.0 - std::cos(0.11)), 0.06 * 0.5 * 0.11 * 0.11);
    }
}

TEST(EffectForms, StiffnessFollowsItsFormulaAtEveryPoint) {
    const test::HeldBeam beam = test::held_beam();
    const Eigen::Matrix3Xd points = model::rest_points(*beam.context.body);
    const Affected graded = test::with_effect(beam, "stiffness_gradient", {{"relative_change", 0.4}, {"axis", 0.0}});
    const Affected drifted = test::with_effect(beam, "modulus_drift", {{"rate_1_s", 1e-3}});
    const Eigen::Vector3d centre(0.05, 0.015, 0.015);
    const Affected patched = test::with_effect(
        beam, "soft_patch", {{"relative_change", -0.5}, {"centre_m", Eigen::VectorXd(centre)}, {"radius_m", 0.02}});
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
        EXPECT_NEAR(graded.model.point_factors(i), 1.0 + 0.4 * (points(0, i) / 0.12 - 0.5), 1e-9);
        EXPECT_NEAR(patched.model.point_factors(i),
                    1.0 - 0.5 * std::exp(-(points.col(i) - centre).squaredNorm() / 8e-4), 1e-9);
    }
    for (std::size_t c = 0; c < beam.affected.model.moduli.size(); ++c)
        EXPECT_NEAR(drifted.model.moduli[c].mu / beam.affected.model.moduli[c].mu, 1.1, 1e-9);
}

TEST(EffectForms, PlacesOnTheSurfaceReproduceThePoint) {
    for (const fem::ElementKind kind : {fem::ElementKind::hex8, fem::ElementKind::tet10}) {
        test::HeldBeam beam = test::held_beam({4, 1, 1});
        beam.spec.kind = kind;
        const model::BodyPointer body = test::make_beam(beam.spec).body;
        for (const Eigen::Vector3d& point : {Eigen::Vector3d(0.11, 0.012, 0.03), Eigen::Vector3d(0.12, 0.001, 0.029),
                                             Eigen::Vector3d(0.07, 0.0, 0.013)}) {
            const SurfacePlace place = surface_place(*body, point);
            EXPECT_GE(place.shares.minCoeff(), 0.0);
            EXPECT_NEAR(place.shares.sum(), 1.0, 1e-12);
            EXPECT_LT((body->mesh.nodes(Eigen::all, place.nodes) * place.shares - place.point).norm(), 1e-9);
        }
    }
}

}  // namespace
}  // namespace myo::effect
