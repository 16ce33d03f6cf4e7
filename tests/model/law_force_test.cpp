#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "mesh/cells.hpp"
#include "model/elastic_bed.hpp"
#include "model/law_cases.hpp"
#include "model/surface_drag.hpp"
#include "support/hollow.hpp"

namespace myo::model {
namespace {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;

InternalEnergy evaluated(const ForceElement& element, const Body& body, const ForceState& at, HessianKind kind) {
    InternalEnergy out;
    out.gradient = Matrix3Xd::Zero(3, body.node_count());
    if (kind != HessianKind::none) out.hessian = body.pattern.zero;
    element.add(body, at, kind, out);
    return out;
}

TEST(LawForce, IsTheElementThatItRepeats) {
    const Model model = test::hollow_block(fem::ElementKind::tet10);
    const Body& body = *model.body;
    const Matrix3Xd x = body.mesh.nodes + 2e-4 * test::rough_field(body.node_count(), 0.2),
                    v = test::rough_field(body.node_count(), 1.2);
    const ForceState at{x, &v, 200.0, 0.1};
    const auto compare = [&](const ForceElement& law, const ForceElement& built_in) {
        for (const HessianKind kind : {HessianKind::exact, HessianKind::positive}) {
            const InternalEnergy a = evaluated(law, body, at, kind), b = evaluated(built_in, body, at, kind);
            EXPECT_NEAR(a.energy, b.energy, 1e-12 * std::abs(b.energy));
            EXPECT_LT((a.gradient - b.gradient).norm(), 1e-12 * b.gradient.norm());
            EXPECT_LT((a.hessian.coeffs() - b.hessian.coeffs()).matrix().norm(),
                      1e-12 * b.hessian.coeffs().matrix().norm());
        }
    };
    compare(*test::law_element(body, "drag", 0), *surface_drag(body, free_faces(body), 0.0, 900.0));
    const ForceElementPointer bed = test::law_element(body, "bed", 0);
    compare(*bed->changed(Eigen::Vector2d(3e5, 0.0)), *elastic_bed(body, free_faces(body), 3e5));
}

TEST(LawForce, SeesWhetherThereIsAPotential) {
    const auto potential = [](const char* name) { return test::compiled(test::law_case(name))->potential; };
    EXPECT_EQ(potential("drag"), LawPotential::of_velocity);
    EXPECT_EQ(potential("bed"), LawPotential::of_positions);
    EXPECT_EQ(potential("bed_energy"), LawPotential::energy);
    EXPECT_EQ(potential("damper"), LawPotential::of_both);
    const auto degree = [](const char* name) { return test::compiled(test::law_case(name))->degree; };
    EXPECT_NEAR(degree("drag"), 2.0, 1e-12);
    EXPECT_EQ(degree("bed"), 0.0) << "a sum of two powers";
    EXPECT_EQ(degree("damper"), 0.0);
    for (const char* name : {"pressure", "wet_drag", "lift", "point", "volume"})
        EXPECT_EQ(potential(name), LawPotential::none) << name;
}

/// A law that adds energy must not let the solver divide the steps in which it does.
TEST(LawForce, SaysWhetherItMayGainEnergy) {
    const Model model = test::hollow_block(fem::ElementKind::hex8);
    const auto steady = [&](const char* name) { return test::law_element(*model.body, name, 0)->steady(0.0, 1.0); };
    for (const char* name : {"drag", "bed", "bed_energy", "wind"}) EXPECT_TRUE(steady(name)) << name;
    for (const char* name : {"stream", "pressure", "lift", "damper", "volume"}) EXPECT_FALSE(steady(name)) << name;
}

TEST(LawForce, HasAPotentialIfItIsConstant) {
    const Model model = test::hollow_block(fem::ElementKind::hex8);
    const Body& body = *model.body;
    const ForceElementPointer wind = test::law_element(body, "wind", 0);
    const Matrix3Xd x = body.mesh.nodes + 2e-4 * test::rough_field(body.node_count(), 0.2);
    const InternalEnergy there = evaluated(*wind, body, {x}, HessianKind::none);
    EXPECT_NE(there.energy, 0.0);
    EXPECT_NEAR(there.energy, there.gradient.cwiseProduct(x - body.mesh.nodes).sum(), 1e-12 * std::abs(there.energy));
}

TEST(LawForce, HasNoNegativeStiffnessWhereNoneIsAllowed) {
    const Model model = test::hollow_block(fem::ElementKind::hex8);
    const Body& body = *model.body;
    const Matrix3Xd x = body.mesh.nodes + 2e-3 * test::rough_field(body.node_count(), 0.2);
    const ForceElementPointer wavy = test::law_element(body, "bed_energy", 0)->changed(Eigen::Vector2d(0.0, 0.5));
    const VectorXd d = gather(body.pattern, test::rough_field(body.node_count(), 0.9));
    const auto curvature = [&](HessianKind kind) {
        return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(
                   Eigen::MatrixXd(
                       Eigen::MatrixXd(evaluated(*wavy, body, {x}, kind).hessian).selfadjointView<Eigen::Lower>()))
            .eigenvalues()(0);
    };
    EXPECT_LT(curvature(HessianKind::exact), -1e-2);
    EXPECT_GT(curvature(HessianKind::positive), -1e-9);
}

/// A pressure over the closed outer and inner surface gives no force; with it growing along z, its buoyancy.
TEST(LawForce, ActsOnTheDeformedSurface) {
    Model model = test::hollow_block(fem::ElementKind::hex8);
    model.body = make_body(model.body->mesh, fem::ElementKind::hex8, {});
    const Body& body = *model.body;
    const Matrix3Xd x = body.mesh.nodes + 1e-3 * test::rough_field(body.node_count(), 0.2);
    const Matrix3Xd forces = -evaluated(*test::law_element(body, "pressure", 0), body, {x}, HessianKind::none).gradient;
    double volume = 0.0;
    for (int c = 0; c < body.cell_count(); ++c) {
        // By the divergence of x over the cells.
        volume += mesh::with_cell(body.mesh.type, [&](auto of_type) {
            using Cell = decltype(of_type);
            Eigen::Matrix<double, 3, Cell::nodes> nodes;
            for (int a = 0; a < Cell::nodes; ++a) nodes.col(a) = x.col(body.mesh.cells(a, c));
            double sum = 0.0;
            for (const mesh::QuadraturePoint& point : mesh::hex_gauss(3))
                sum += point.weight * Eigen::Matrix3d(nodes * Cell::derivatives(point.xi)).determinant();
            return sum;
        });
    }
    const Eigen::Vector3d total = forces.rowwise().sum();
    EXPECT_NEAR(total.z(), -4e3 / 0.1 * volume, 1e-9 * 4e3 / 0.1 * volume);
    EXPECT_NEAR(total.head<2>().norm(), 0.0, 1e-9 * std::abs(total.z()));
}

}  // namespace
}  // namespace myo::model
