#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "diagnosis/diagnosis_policy.hpp"
#include "diagnosis/missing_force/force_fields.hpp"
#include "diagnosis/missing_force/timed_forces.hpp"
#include "mesh/box_mesh.hpp"

// Basis of a missing force on a block of two cells: places along the body, and potentials.

namespace myo::diagnosis::force_basis_test {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::VectorXd;

/// Block of 2 x 1 x 1 cells of this edge length [m], whose nodes at these x [cells] are held.
model::BodyPointer block(const std::vector<double>& held_x, double edge_m = 1.0) {
    mesh::VolumeMesh mesh = mesh::box_hex_mesh({Eigen::Vector3d::Zero(), {2.0, 1.0, 1.0}}, {2, 1, 1});
    std::vector<int> held;
    for (Index i = 0; i < mesh.nodes.cols(); ++i)
        for (const double x : held_x)
            if (mesh.nodes(0, i) == x) held.push_back(static_cast<int>(i));
    mesh.nodes *= edge_m;
    return model::make_body(mesh, fem::ElementKind::hex8, held);
}

TEST(ForcePlaces, RunFromTheClampToTheFarEnd) {
    for (const auto& [held, from_left] :
         {std::pair{std::vector<double>{0.0}, true}, {{2.0}, false}, {{}, true}, {{0.0, 2.0}, true}}) {
        const double edge_m = 0.0137;  // coordinates of both ends do not cancel exactly
        const model::BodyPointer body = block(held, edge_m);
        const VectorXd place = force_fields(*body, MissingForcePolicy{}).place;
        for (Index i = 0; i < place.size(); ++i) {
            const double along = 0.5 * body->mesh.nodes(0, i) / edge_m;
            EXPECT_NEAR(place(i), from_left ? along : 1.0 - along, 1e-12) << held.size();
        }
    }
}

/// A force of 2 N along y at one node, which jumps from 1 to 3 times that at half a second, and a constant one along z.
model::ForceElementPointer jumping(const model::Body& body, double factor) {
    Matrix3Xd along_y = Matrix3Xd::Zero(3, body.node_count()), along_z = along_y;
    along_y(1, 4) = 2.0;
    along_z(2, 7) = 5.0;
    return timed_forces({{along_y, fibre::Signal::step(0.5, 1.0, 3.0)}, {along_z, fibre::Signal::constant(1.0)}},
                        factor);
}

model::InternalEnergy energy_at(const model::ForceElement& force, const model::Body& body, const Matrix3Xd& x,
                                double time_s, bool before_jump) {
    model::InternalEnergy out;
    out.gradient = Matrix3Xd::Zero(3, body.node_count());
    force.add(body, {x, nullptr, 0.0, time_s, before_jump}, model::HessianKind::none, out);
    return out;
}

TEST(TimedForcePotential, FallsByTheWorkOfTheForce) {
    const model::BodyPointer body = block({});
    const model::ForceElementPointer force = jumping(*body, 1.5);
    Matrix3Xd x = body->mesh.nodes;
    EXPECT_EQ(energy_at(*force, *body, x, 0.0, false).energy, 0.0);
    x(1, 4) += 0.1;
    x(2, 7) -= 0.2;
    x(0, 4) += 7.0;  // no force acts along x
    EXPECT_NEAR(energy_at(*force, *body, x, 0.0, false).energy, -1.5 * (2.0 * 0.1 - 5.0 * 0.2), 1e-12);
}

TEST(TimedForcePotential, HasBothLimitsAtAJump) {
    const model::BodyPointer body = block({});
    const model::ForceElementPointer force = jumping(*body, 1.0);
    const auto along_y = [&](bool before) {
        return energy_at(*force, *body, body->mesh.nodes, 0.5, before).gradient(1, 4);
    };
    EXPECT_EQ(along_y(true), -2.0);
    EXPECT_EQ(along_y(false), -6.0);
    EXPECT_EQ(force->jumps(), std::vector<double>{0.5});
    EXPECT_TRUE(force->steady(0.0, 0.4));
    EXPECT_FALSE(force->steady(0.4, 0.6));
}

}  // namespace
}  // namespace myo::diagnosis::force_basis_test
