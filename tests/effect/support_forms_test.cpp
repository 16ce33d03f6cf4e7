#include <gtest/gtest.h>

#include "effect/places.hpp"
#include "measurement/observe.hpp"
#include "plain_body.hpp"
#include "support/figures.hpp"

namespace myo::effect {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

class SupportForms : public testing::TestWithParam<fem::ElementKind> {};

double deflection(const test::HeldBeam& beam, const model::Model& model) { return test::tip_at_rest(beam, model).z(); }

/// Held over its first sixth, a force at its end and nothing else.
test::HeldBeam pushed(fem::ElementKind kind, Eigen::Vector3i cells = {12, 2, 4}) {
    test::HeldBeam beam = test::held_beam(cells, kind);
    beam.affected.model.gravity_m_s2.setZero();
    beam.affected.model.fibres = std::make_shared<std::vector<fibre::FibreGroup>>();
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
    model::Model shorter = beam.affected.model;
    shorter.body = model::make_body(
        shorter.body->mesh, beam.spec.kind,
        mesh::nodes_in_box(shorter.body->mesh, {{-1.0, -1.0, -1.0}, {0.01 + 1e-9, 1.0, 1.0}}));
    const double expected = deflection(beam, shorter);
    EXPECT_GT(expected, 1.2 * declared);
    EXPECT_NEAR(deflection(beam, slipped.model), expected, 0.03 * (expected - declared));
    // Where a marker hangs on the cells in front of the clamp, these alone reach back.
    beam.context.markers = measurement::marker_set(beam.context.body->mesh, {{0.024, 0.015, 0.03}}).bindings;
    EXPECT_NEAR(deflection(beam, test::with_effect(beam, "clamp_slip", {{"free_length_m", 0.01}}).model), expected,
                0.1 * (expected - declared));
    beam.context.markers.clear();
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
    beam.context.markers = measurement::marker_set(beam.context.body->mesh, {on_first_cell}).bindings;
    const double free_m = 0.006;
    const Affected slipped = test::with_effect(beam, "clamp_slip", {{"free_length_m", free_m}});
    const model::Body& body = *slipped.model.body;
    EXPECT_NEAR(mesh::cell_volumes(body.mesh).sum(), mesh::cell_volumes(beam.context.body->mesh).sum(), 1e-12);
    EXPECT_GT(
        mesh::cell_volumes(test::with_effect(beam, "clamp_slip", {{"free_length_m", 1.0}}).model.body->mesh).minCoeff(),
        0.0);  // something stays held
    const Eigen::Matrix3d stretch = Vector3d(1.2, 0.9, 1.0).asDiagonal();
    const Matrix3Xd x = stretch * body.mesh.nodes;
    for (std::size_t g = 0; g < slipped.model.fibres->size(); ++g) {
        const fibre::FibreGroup& group = (*slipped.model.fibres)[g];
        EXPECT_NEAR(group.volume(), (*beam.affected.model.fibres)[g].volume() * (0.1 + free_m) / 0.1, 1e-12);
        for (const fibre::FibrePoint& point : group.points)
            EXPECT_LT((x(Eigen::all, body.mesh.cells.col(point.cell)) * point.shape - Vector3d(1.2, 0.0, 0.0)).norm(),
                      1e-9);
    }
    const measurement::MarkerBinding& marker = beam.context.markers.front();
    std::vector<Matrix3Xd> tracks{body.mesh.nodes(Eigen::all, marker.nodes) * marker.weights};
    EXPECT_GT((tracks[0] - on_first_cell).norm(), 0.1 * free_m);
    EXPECT_LT(
        (measurement::observed_tracks(slipped.observation_error, tracks, VectorXd::Zero(1))[0] - on_first_cell).norm(),
        1e-12);
}

/// A beam of the proportions that soft specimens have.
test::HeldBeam held_bar(fem::ElementKind kind, double poissons_ratio = 0.45) {
    test::BeamSpec spec = test::slender_beam(kind);
    if (kind == fem::ElementKind::hex8)
        spec.cells = {20, 4, 4};
    else
        spec.cells = {10, 2, 2};
    spec.size = {0.1, 0.02, 0.02};
    spec.poissons_ratio = poissons_ratio;
    return test::plain_body(spec);
}

Matrix3Xd pose(const test::HeldBeam& beam, const Vector3d& offset_m) {
    return test::with_effect(beam, "held_pose", {{"offset_m", VectorXd(offset_m)}}).options.initial.positions;
}

/// The static shape under an end force, the free end's centre brought to where it is in the pose.
Matrix3Xd solved_pose(const test::HeldBeam& beam, const Vector3d& offset_m) {
    model::Model model = beam.affected.model;
    test::push_tip(model, beam.spec, offset_m / test::end_compliance(beam.spec));
    Matrix3Xd x;
    for (int correction = 0; correction < 6; ++correction) {
        x = test::at_rest(model);
        const Vector3d tip = test::tip_displacement(model, beam.spec, x);
        model.forces.back().force_N *= offset_m.norm() / tip.tail<2>().norm();
    }
    return x;
}

/// Differences from the solved shape over the offset, root mean square of the nodes on the surface and the largest of
/// them.
TEST_P(SupportForms, AHeldPoseIsTheStaticShapeUnderAnEndForce) {
    const test::HeldBeam beam = held_bar(GetParam());
    const model::Model& model = beam.affected.model;
    for (const Vector3d& offset :
         {Vector3d(0.0, 0.0, 0.004), Vector3d(0.0, -0.012, 0.016), Vector3d(0.0, 0.0, -0.04)}) {
        const Matrix3Xd found = pose(beam, offset), expected = solved_pose(beam, offset), X = model.body->mesh.nodes;
        const Matrix3Xd error = found - expected;
        const double rms = std::sqrt(error.squaredNorm() / static_cast<double>(error.cols())),
                     largest = error.colwise().norm().maxCoeff();
        const Vector3d tip = test::tip_displacement(model, beam.spec, found),
                       solved = test::tip_displacement(model, beam.spec, expected);
        const std::string at = format_number(1e3 * offset.norm()) + "_mm";
        test::record("rms_" + at, rms / offset.norm());
        test::record("largest_" + at, largest / offset.norm());
        test::record("end_comes_nearer_" + at, {tip.x(), solved.x()});
        EXPECT_LT(rms, 0.012 * offset.norm());
        EXPECT_LT(largest, 0.05 * offset.norm());
        EXPECT_NEAR(tip.x(), solved.x(), 0.012 * offset.norm());
        for (Eigen::Index i = 0; i < X.cols(); ++i)
            if (X(0, i) == 0.0) {
                EXPECT_EQ(found.col(i), X.col(i));
            }
    }
}

/// What it was before sections turned: the marker moved across alone.
TEST_P(SupportForms, AHeldPoseTurnsItsSections) {
    const test::HeldBeam beam = held_bar(GetParam());
    const measurement::MarkerSet markers = measurement::marker_set(beam.context.body->mesh, {{0.09, 0.01, 0.02}});
    const auto shift = [&](const Matrix3Xd& x) {
        const measurement::MarkerBinding& marker = markers.bindings[0];
        return Vector3d(measurement::marker_position(marker, x(Eigen::all, marker.nodes)) - Vector3d(0.09, 0.01, 0.02));
    };
    const Vector3d offset(0.0, 0.0, 0.004), found = shift(pose(beam, offset)),
                                            solved = shift(solved_pose(beam, offset));
    test::record("along_m", {found.x(), solved.x()});
    // 1.5 x 0.04 x 0.99 x 10 mm by the turn, less 3 % for shear, and 0.08 mm as the axis is bent.
    EXPECT_NEAR(found.x(), -0.65e-3, 0.02e-3);
    EXPECT_NEAR(found.x(), solved.x(), 0.02e-3);
}

/// The end's centre goes where it is told to across the axis; what is along it follows, as the axis keeps its length.
TEST_P(SupportForms, AHeldPoseMovesTheFreeEndsCentreByItsOffset) {
    const test::HeldBeam beam = held_bar(GetParam());
    const double L = beam.spec.size(0);
    for (const double part : {0.01, 0.1, 0.4, 0.7}) {
        const Vector3d offset = part * L * Vector3d(0.0, 0.6, -0.8);
        const Vector3d tip = test::tip_displacement(beam.affected.model, beam.spec, pose(beam, offset));
        EXPECT_NEAR((tip - offset).tail<2>().norm(), 0.0, 1e-9 * L) << part;
        if (part <= 0.1) {
            EXPECT_NEAR(tip.x() / (-0.6 * part * part * L), 1.0, 0.05) << part;
        }
        EXPECT_LT((pose(beam, offset + 0.3 * L * Vector3d::UnitX()) - pose(beam, offset)).norm(), 1e-12)
            << "along the axis it says nothing";
    }
    // A number is a size against gravity, upwards where there is none.
    const Matrix3Xd up = test::with_effect(beam, "held_pose", {{"offset_m", 0.01}}).options.initial.positions;
    EXPECT_LT((up - pose(beam, {0.0, 0.0, 0.01})).norm(), 1e-12);
    test::HeldBeam hanging = beam;
    hanging.affected.model.gravity_m_s2 = {9.81, 0.0, 0.0};
    const Matrix3Xd aside = test::with_effect(hanging, "held_pose", {{"offset_m", 0.01}}).options.initial.positions;
    EXPECT_NEAR(test::tip_displacement(beam.affected.model, beam.spec, aside).y(), 0.01, 1e-9);
    // It is let go straight or not at all.
    test::HeldBeam resting = beam;
    resting.context.start = dynamics::StartKind::equilibrium;
    EXPECT_EQ(pose(resting, {0.0, 0.0, 0.01}).size(), 0);
}

/// Along every component, also through no offset at all.
TEST(EffectForms, AHeldPoseIsSmoothInItsOffset) {
    const test::HeldBeam beam = held_bar(fem::ElementKind::hex8);
    for (const Vector3d& offset : {Vector3d(0.0, 0.0, 0.0), Vector3d(0.0, 1e-4, 0.0), Vector3d(0.0, 0.004, -0.02)})
        for (const Vector3d& along : {Vector3d(0.0, 1.0, 0.0), Vector3d(0.0, 0.0, 1.0)}) {
            const auto slope = [&](double width) {
                return Matrix3Xd((pose(beam, offset + width * along) - pose(beam, offset - width * along)) /
                                 (2.0 * width));
            };
            EXPECT_GT(slope(1e-6).norm(), 1.0);
            EXPECT_LT((slope(2e-5) - slope(2e-6)).norm(), 1e-5 * slope(2e-6).norm()) << offset.transpose();
        }
}

INSTANTIATE_TEST_SUITE_P(OnTwoMeshes, SupportForms, testing::ValuesIn(test::two_kinds),
                         [](const auto& given) { return to_string(given.param); });

}  // namespace
}  // namespace myo::effect
