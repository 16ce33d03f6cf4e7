#include "model/directional_mass.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "base/decompositions.hpp"
#include "model/loaded_face.hpp"
#include "support/beam.hpp"
#include "support/differences.hpp"

namespace myo::model {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;

constexpr double per_area = 3.7;  // [kg/m2]

/// What a motion of all nodes alike feels: the sum of all 3 x 3 blocks.
Matrix3d rigid_mass(const DirectionalMass& mass) {
    Matrix3d sum;
    Matrix3Xd u(3, mass.inertia_kg.cols() / 3), Du = Matrix3Xd::Zero(3, u.cols());
    for (int r = 0; r < 3; ++r) {
        u = Vector3d::Unit(r).replicate(1, u.cols());
        Du.setZero();
        add_directional(mass.inertia_kg, u, Du);
        sum.col(r) = Du.rowwise().sum();
    }
    return sum;
}

/// A box displaces fluid along x with its two faces across x, and so on; slip along the other faces costs nothing.
TEST(AddedMass, OfABoxMovedAsAWholeIsThatOfItsFacesAcrossTheMotion) {
    for (const fem::ElementKind kind : {fem::ElementKind::hex8, fem::ElementKind::tet4, fem::ElementKind::tet10}) {
        test::BeamSpec spec;
        spec.kind = kind;
        spec.size = {0.1, 0.03, 0.02};
        spec.clamped = false;
        const Model model = test::make_beam(spec);
        const DirectionalMass mass = added_mass(*model.body, free_faces(*model.body), per_area);
        const Vector3d pairs_of_faces = 2.0 * spec.size.prod() * spec.size.cwiseInverse();
        const Matrix3d expected = (per_area * pairs_of_faces).asDiagonal();
        EXPECT_LT((rigid_mass(mass) - expected).norm(), 1e-13 * expected.norm()) << to_string(kind);
        EXPECT_LT((rigid_mass(added_mass(*model.body, {}, per_area))).norm(), 1e-300);
    }
}

TEST(AddedMass, OfAHeldBodyLeavesTheClampedFaceOut) {
    test::BeamSpec spec;
    const Model model = test::make_beam(spec);
    const Matrix3d rigid = rigid_mass(added_mass(*model.body, free_faces(*model.body), per_area));
    EXPECT_NEAR(rigid(0, 0), per_area * spec.size(1) * spec.size(2), 1e-14) << "the free end alone";
    EXPECT_NEAR(rigid(1, 1), 2.0 * per_area * spec.size(0) * spec.size(2), 1e-14);
}

/// Faces that lie oblique, and warped ones: the sum over a closed surface has the trace of its area; no motion has
/// negative inertia.
TEST(AddedMass, IsSymmetricAndPositiveWithTheTraceOfTheArea) {
    for (const mesh::CellType type : {mesh::CellType::hex8, mesh::CellType::tet10}) {
        const mesh::VolumeMesh mesh = test::distorted_mesh(type, {2, 2, 1}, 0.2);
        const BodyPointer body = make_body(
            mesh, type == mesh::CellType::hex8 ? fem::ElementKind::hex8 : fem::ElementKind::tet10, {});
        const DirectionalMass mass = added_mass(*body, free_faces(*body), per_area);
        const MatrixXd D = mass.inertia_kg;
        EXPECT_LT((D - D.transpose()).norm(), 1e-14 * D.norm());
        EXPECT_GT(symmetric_eigenvalues(D)(0), -1e-13 * D.norm());
        const double area = mesh::surface_weights(mesh, body->boundary,
                                                  Box{Vector3d::Constant(-10.0), Vector3d::Constant(10.0)})
                                .weight.sum();
        EXPECT_NEAR(rigid_mass(mass).trace() / (per_area * area), 1.0,
                    type == mesh::CellType::hex8 ? 1e-2 : 1e-12);  // warped faces have no closed form
    }
}

TEST(LineMass, ResistsAlongItsLineOnly) {
    test::BeamSpec spec;
    const Model model = test::make_beam(spec);
    const Vector3d line(1.0, -2.0, 0.5), d = line.normalized();
    const DirectionalMass mass = line_mass(test::tip_share(model, spec), line, 0.05);
    EXPECT_LT((rigid_mass(mass) - 0.05 * d * d.transpose()).norm(), 1e-16);
    EXPECT_LT((rigid_mass(mass) * d.unitOrthogonal()).norm(), 1e-16);
}

TEST(MassMatrix, AddsDirectionalMassesAsThePlainProductDoesAndWeighsThemNot) {
    test::BeamSpec spec;
    spec.gravity_m_s2 = 9.81;
    Model model = test::make_beam(spec);
    const MassMatrix plain = mass_matrix(model);
    EXPECT_FALSE(plain.has_directional());
    const Matrix3Xd weight = external_forces(model, plain, 0.0), X = test::rough_field(model.body->node_count(), 0.7);
    model.directional_masses = {added_mass(*model.body, free_faces(*model.body), per_area),
                                line_mass(test::tip_share(model, spec), Vector3d(1.0, 1.0, 0.0), 0.2)};
    const MassMatrix mass = mass_matrix(model);
    ASSERT_TRUE(mass.has_directional());
    EXPECT_EQ((external_forces(model, mass, 0.0) - weight).norm(), 0.0);
    const MatrixXd D = MatrixXd(model.directional_masses[0].inertia_kg) +
                       MatrixXd(model.directional_masses[1].inertia_kg);
    const Eigen::VectorXd product = D * Eigen::Map<const Eigen::VectorXd>(X.data(), X.size());
    const Matrix3Xd added = times_mass(X, mass) - times_mass(X, plain);
    EXPECT_GT(product.norm(), 0.0);
    EXPECT_LT((Eigen::Map<const Eigen::VectorXd>(added.data(), added.size()) - product).norm(), 1e-13 * product.norm());
    // Several fields side by side, as tangents have them.
    MatrixXd fields(6, X.cols()), result = MatrixXd::Zero(6, X.cols());
    fields << X, 2.0 * X;
    add_directional(mass.directional, fields, result);
    EXPECT_LT((result.topRows(3) - added).norm() + (result.bottomRows(3) - 2.0 * added).norm(), 1e-12 * added.norm());
}

TEST(MassMatrix, HasNoDirectionalPartOfMassesOfZero) {
    test::BeamSpec spec;
    Model model = test::make_beam(spec);
    model.directional_masses = {added_mass(*model.body, free_faces(*model.body), 0.0)};
    EXPECT_FALSE(mass_matrix(model).has_directional());
}

/// A run begins at t = 0: what has ended by then takes no span, and each mass is in those of its window.
TEST(DirectionalMass, IsInTheSpansOfItsWindow) {
    test::BeamSpec spec;
    Model model = test::make_beam(spec);
    EXPECT_EQ(mass_spans(model).size(), 1u);
    const Eigen::VectorXd share = test::tip_share(model, spec);
    const double inf = std::numeric_limits<double>::infinity();
    const std::vector<std::array<double, 2>> windows{{-inf, inf}, {-2.0, 0.0}, {-1.0, 0.5}, {0.5, 0.8}, {0.2, inf}};
    double kg = 1.0;  // each twice the one before, so that sums tell which are there
    for (const auto& [from_s, until_s] : windows) {
        model.directional_masses.push_back(line_mass(share, Vector3d::UnitZ(), kg));
        model.directional_masses.back().from_s = from_s;
        model.directional_masses.back().until_s = until_s;
        kg *= 2.0;
    }
    const std::vector<MassSpan> spans = mass_spans(model);
    const auto total = [&](double t) { return spans[span_at(spans, t)].mass.directional.sum(); };
    EXPECT_EQ(spans.size(), 4u);
    EXPECT_NEAR(total(0.0), 1.0 + 4.0, 1e-12);
    EXPECT_NEAR(total(0.2), 1.0 + 4.0 + 16.0, 1e-12);
    EXPECT_NEAR(total(0.499), 1.0 + 4.0 + 16.0, 1e-12);
    EXPECT_NEAR(total(0.5), 1.0 + 8.0 + 16.0, 1e-12);
    EXPECT_NEAR(total(0.8), 1.0 + 16.0, 1e-12);
    EXPECT_EQ(jump_times(model), (std::vector<double>{-2.0, -1.0, 0.0, 0.2, 0.5, 0.8}));
}

}  // namespace
}  // namespace myo::model
