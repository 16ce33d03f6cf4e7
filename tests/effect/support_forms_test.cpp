#include <gtest/gtest.h>

#include "effect/places.hpp"
#include "measurement/observe.hpp"
#include "plain_body.hpp"
#include "support/figures.hpp"

namespace myo {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

class SupportForms : public testing::TestWithParam<ElementKind> {};

double deflection(const test::HeldBeam& beam, const Model& model) { return test::tip_at_rest(beam, model).z(); }

/// Held over its first sixth, a force at its end and nothing else.
test::HeldBeam pushed(ElementKind kind, Eigen::Vector3i cells = {12, 2, 4}) {
    test::HeldBeam beam = test::held_beam(cells, kind);
    beam.affected.model.gravity_m_s2.setZero();
    beam.affected.model.fibres = std::make_shared<std::vector<FibreGroup>>();
    beam.affected.model.activation.clear();
    beam.affected.model.forces.clear();
    test::push_tip(beam.affected.model, beam.spec, {0.0, 0.0, 1e-3});
    return beam;
}

/// A rigid plate on the bed, as far as Poisson's ratio is 0.
TEST_P(SupportForms, ACompliantClampTurnsAndShiftsTheBeam) {
    const test::BeamSpec spec = test::slender_beam(GetParam());
    test::HeldBeam beam = test::plain_body(spec);
    const double F = 1e-5, k = 2e7, L = spec.size(0);
    test::push_tip(beam.affected.model, spec, {0.0, 0.0, F});
    const Affected soft = test::with_effect(beam, "clamp_compliance", {{"stiffness_Pa_per_m", k}});
    const double more = deflection(beam, soft.model) - deflection(beam, beam.affected.model);
    const double expected = F / (k * section_area(spec)) + F * L * L / (k * second_moment(spec));
    test::record("relative_error", more / expected - 1.0);
    EXPECT_NEAR(more / expected, 1.0, 0.03);
}

TEST_P(SupportForms, ASlippingClampFreesAsMuchLength) {
    test::HeldBeam beam = pushed(GetParam());
    const double declared = deflection(beam, beam.affected.model);
    // Half of the clamp's two cells, where a mesh can say the same exactly.
    const Affected slipped = test::with_effect(beam, "clamp_slip", {{"free_length_m", 0.01}});
    Model shorter = beam.affected.model;
    shorter.body = make_body(shorter.body->mesh, beam.spec.kind,
                             nodes_in_box(shorter.body->mesh, {{-1.0, -1.0, -1.0}, {0.01 + 1e-9, 1.0, 1.0}}));
    const double expected = deflection(beam, shorter);
    EXPECT_GT(expected, 1.2 * declared);
    EXPECT_NEAR(deflection(beam, slipped.model), expected, 0.03 * (expected - declared));
    // Where a marker hangs on the cells in front of the clamp, these alone reach back.
    beam.site.markers = marker_set(beam.site.body->mesh, {{0.024, 0.015, 0.03}}).bindings;
    EXPECT_NEAR(deflection(beam, test::with_effect(beam, "clamp_slip", {{"free_length_m", 0.01}}).model), expected,
                0.1 * (expected - declared));
    beam.site.markers.clear();
    // Within a cell the deflection grows as that of ever longer cantilevers.
    const double L = 0.1;
    for (const double free_m : {0.0025, 0.005, 0.0075}) {
        const double part = (std::pow(L + free_m, 3) - std::pow(L, 3)) / (std::pow(L + 0.01, 3) - std::pow(L, 3));
        const Affected between = test::with_effect(beam, "clamp_slip", {{"free_length_m", free_m}});
        const double found = (deflection(beam, between.model) - declared) / (expected - declared);
        test::record("part_error_" + format_number(1e3 * free_m), found - part);
        EXPECT_NEAR(found, part, 0.03) << free_m;
    }
}

/// The muscles reach as far as the cells in front of the clamp do, and nobody moved the markers there.
TEST(EffectForms, ASlippingClampLeavesMusclesAndMarkersAtRest) {
    test::HeldBeam beam = test::held_beam();
    const Vector3d on_first_cell(0.024, 0.015, 0.03);
    beam.site.markers = marker_set(beam.site.body->mesh, {on_first_cell}).bindings;
    const double free_m = 0.006;
    const Affected slipped = test::with_effect(beam, "clamp_slip", {{"free_length_m", free_m}});
    const Body& body = *slipped.model.body;
    EXPECT_NEAR(cell_volumes(body.mesh).sum(), cell_volumes(beam.site.body->mesh).sum(), 1e-12);
    EXPECT_GT(cell_volumes(test::with_effect(beam, "clamp_slip", {{"free_length_m", 1.0}}).model.body->mesh).minCoeff(),
              0.0);   // something stays held
    const Eigen::Matrix3d stretch = Vector3d(1.2, 0.9, 1.0).asDiagonal();
    const Matrix3Xd x = stretch * body.mesh.nodes;
    for (std::size_t g = 0; g < slipped.model.fibres->size(); ++g) {
        const FibreGroup& group = (*slipped.model.fibres)[g];
        EXPECT_NEAR(group.volume(), (*beam.affected.model.fibres)[g].volume() * (0.1 + free_m) / 0.1, 1e-12);
        for (const FibrePoint& point : group.points)
            EXPECT_LT((x(Eigen::all, body.mesh.cells.col(point.cell)) * point.shape - Vector3d(1.2, 0.0, 0.0)).norm(),
                      1e-9);
    }
    const MarkerBinding& marker = beam.site.markers.front();
    std::vector<Matrix3Xd> tracks{body.mesh.nodes(Eigen::all, marker.nodes) * marker.weights};
    EXPECT_GT((tracks[0] - on_first_cell).norm(), 0.1 * free_m);
    EXPECT_LT((seen_tracks(slipped.seen, tracks, VectorXd::Zero(1))[0] - on_first_cell).norm(), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(OnTwoMeshes, SupportForms, testing::ValuesIn(test::two_kinds),
                         [](const auto& given) { return to_string(given.param); });

}  // namespace
}  // namespace myo
