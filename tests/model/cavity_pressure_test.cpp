#include "model/cavity_pressure.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "fibre/signal.hpp"
#include "mesh/box_mesh.hpp"
#include "model/body.hpp"
#include "model/force_of.hpp"
#include "support/hollow.hpp"
#include "support/meshes.hpp"

namespace myo::model::cavity_pressure_tests {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using fibre::Signal;

constexpr fem::ElementKind kinds[] = {fem::ElementKind::hex8, fem::ElementKind::tet4, fem::ElementKind::tet10};

/// A block of 7 x 3 x 3 cells of 10 mm with holes of one cell and of two, and clamped nodes.
BodyPointer two_holes(fem::ElementKind kind, const std::vector<int>& clamped = {}) {
    mesh::VolumeMesh mesh = test::box_mesh(kind, {Vector3d::Zero(), {0.07, 0.03, 0.03}}, {7, 3, 3});
    mesh = test::without(mesh, {{0.01, 0.01, 0.01}, {0.02, 0.02, 0.02}});
    mesh = test::without(mesh, {{0.04, 0.01, 0.01}, {0.06, 0.02, 0.02}});
    return make_body(std::move(mesh), kind, clamped);
}

/// A deformation with det F = 1.3.
Matrix3d some_gradient() {
    Matrix3d F;
    F << 1.1, 0.2, -0.1, 0.05, 0.9, 0.3, 0.15, -0.2, 1.2;
    return F * std::cbrt(1.3 / F.determinant());
}

TEST(ClosedCavities, AreTheHolesAndNotTheOutside) {
    for (const fem::ElementKind kind : kinds) {
        const BodyPointer body = two_holes(kind);
        std::vector<std::vector<int>> cavities = closed_cavities(*body);
        ASSERT_EQ(cavities.size(), 2u);
        std::vector<double> volumes;
        for (const std::vector<int>& cavity : cavities) {
            EXPECT_EQ(open_edges(*body, cavity), 0);
            volumes.push_back(cavity_volume(*body, cavity, body->mesh.nodes));
        }
        std::sort(volumes.begin(), volumes.end());
        EXPECT_NEAR(volumes[0], 1e-6, 1e-17);
        EXPECT_NEAR(volumes[1], 2e-6, 1e-17);
        // Every face belongs to one of the cavities or to the outside, which holds minus the whole.
        std::vector<bool> is_wall(static_cast<std::size_t>(body->boundary.count()), false);
        for (const std::vector<int>& cavity : cavities)
            for (const int face : cavity) {
                EXPECT_FALSE(is_wall[static_cast<std::size_t>(face)]);
                is_wall[static_cast<std::size_t>(face)] = true;
            }
        std::vector<int> outside;
        for (int face = 0; face < static_cast<int>(body->boundary.count()); ++face)
            if (!is_wall[static_cast<std::size_t>(face)]) outside.push_back(face);
        EXPECT_NEAR(cavity_volume(*body, outside, body->mesh.nodes), -0.07 * 0.03 * 0.03, 1e-16);
    }
    const mesh::VolumeMesh solid = test::box_mesh(fem::ElementKind::hex8, test::unit_box(), {2, 2, 2});
    EXPECT_TRUE(closed_cavities(*make_body(solid, fem::ElementKind::hex8, {})).empty());
}

TEST(CavityVolume, IsScaledByTheDeterminantAndMovesAlong) {
    for (const fem::ElementKind kind : kinds) {
        const BodyPointer body = two_holes(kind);
        for (const std::vector<int>& cavity : closed_cavities(*body)) {
            const double rest = cavity_volume(*body, cavity, body->mesh.nodes);
            EXPECT_NEAR(cavity_volume(*body, cavity, test::mapped(body->mesh, some_gradient(), {3.0, -1.0, 2.0})),
                        1.3 * rest, 1e-14)
                << "however far from the origin";
            EXPECT_NEAR(cavity_volume(*body, cavity, -body->mesh.nodes), -rest, 1e-17) << "turned inside out";
        }
    }
}

TEST(WallArea, IsThatOfTheWallsAsDeformed) {
    for (const fem::ElementKind kind : kinds) {
        const BodyPointer body = two_holes(kind);
        const std::vector<std::vector<int>> cavities = closed_cavities(*body);
        double rest = 0.0, stretched = 0.0, turned = 0.0;
        const Matrix3Xd& X = body->mesh.nodes;
        const Matrix3Xd longer = Vector3d(3.0, 1.0, 1.0).asDiagonal() * X, mirrored = -X;
        for (const std::vector<int>& cavity : cavities) {
            rest += wall_area(*body, cavity, X);
            stretched += wall_area(*body, cavity, longer);
            turned += wall_area(*body, cavity, mirrored);
        }
        // Square centimetres: 6 of the cube and 10 of the double one; all but 4 of them along x.
        EXPECT_NEAR(rest, 16e-4, 1e-16);
        EXPECT_NEAR(stretched, 40e-4, 1e-16);
        EXPECT_NEAR(turned, 16e-4, 1e-16);
        EXPECT_EQ(wall_area(*body, {}, X), 0.0);
    }
}

TEST(OpenEdges, AreThoseOfMissingFacesUnlessClamped) {
    const BodyPointer body = two_holes(fem::ElementKind::hex8);
    std::vector<int> cube = closed_cavities(*body)[0], walls;
    if (cube.size() > 6) cube = closed_cavities(*body)[1];
    ASSERT_EQ(cube.size(), 6u);
    // Faces of the cube by their direction: opposite ones share no edge.
    const auto plane_of = [&](int face) {
        const Matrix3Xd at = body->mesh.nodes(Eigen::all, body->boundary.nodes.col(face));
        for (int axis = 0; axis < 3; ++axis)
            if (at.row(axis).maxCoeff() - at.row(axis).minCoeff() < 1e-9) return axis;
        return -1;
    };
    std::stable_sort(cube.begin(), cube.end(), [&](int a, int b) { return plane_of(a) < plane_of(b); });
    EXPECT_EQ(open_edges(*body, {}), 0);
    EXPECT_EQ(open_edges(*body, {cube[0]}), 4);
    EXPECT_EQ(open_edges(*body, {cube[0], cube[1]}), 8) << "two opposite faces";
    EXPECT_EQ(open_edges(*body, {cube[0], cube[2]}), 6) << "neighbours";
    EXPECT_EQ(open_edges(*body, {cube[1], cube[2], cube[3], cube[4], cube[5]}), 4) << "one is missing";
    // Where the rim is clamped at both ends of its edges nothing is open.
    walls.assign(cube.begin() + 1, cube.end());
    const auto rim = body->boundary.nodes.col(cube[0]);
    EXPECT_EQ(open_edges(*two_holes(fem::ElementKind::hex8, {rim(0), rim(1), rim(2), rim(3)}), walls), 0);
    EXPECT_EQ(open_edges(*two_holes(fem::ElementKind::hex8, {rim(0), rim(1), rim(2)}), walls), 2);
    EXPECT_EQ(open_edges(*two_holes(fem::ElementKind::hex8, {rim(0), rim(2)}), walls), 4);
}

/// The work of the pressure along any affine motion is the pressure times the change of the volume, and its walls are
/// pushed outwards.
TEST(CavityPressureForce, DoesTheWorkOfItsVolume) {
    const double p = 5e3;
    for (const fem::ElementKind kind : kinds) {
        const BodyPointer body = two_holes(kind);
        const std::vector<int> walls = closed_cavities(*body)[1];
        const Matrix3Xd x = test::mapped(body->mesh, some_gradient());
        const double volume = cavity_volume(*body, walls, x);
        for (const double factor : {1.0, 0.75}) {
            const InternalEnergy out = test::force_of(*cavity_pressure(*body, walls, Signal::constant(p), "it", factor),
                                                      *body, {x});
            EXPECT_NEAR(out.energy, -factor * p * volume, 1e-12);
            Matrix3d moment = out.gradient * x.transpose();  // virial of the pressure: minus p V times the identity
            EXPECT_LT((moment + factor * p * volume * Matrix3d::Identity()).norm(), 1e-12);
        }
        const Vector3d middle = Matrix3Xd(x).rowwise().mean();
        const Matrix3Xd force = -test::force_of(*cavity_pressure(*body, walls, Signal::constant(p)), *body, {x})
                                     .gradient;
        EXPECT_GT(force.cwiseProduct(x.colwise() - middle).sum(), 0.0) << "outwards";
        EXPECT_EQ(test::force_of(*cavity_pressure(*body, walls, Signal::constant(0.0)), *body, {x}).energy, 0.0);
    }
}

/// The pressure at a jump is that of the side of the state, and a load curve has its jumps and stretches.
TEST(CavityPressureForce, FollowsItsSignal) {
    const BodyPointer body = two_holes(fem::ElementKind::hex8);
    const std::vector<int> walls = closed_cavities(*body)[0];
    const ForceElementPointer element = cavity_pressure(*body, walls, Signal{{0.0, 1.0, 1.0}, {0.0, 4e3, 1e3}});
    const Matrix3Xd& x = body->mesh.nodes;
    const double volume = cavity_volume(*body, walls, x);
    const auto pressure = [&](double t, bool before) {
        return -test::force_of(*element, *body, {x, nullptr, 0.0, t, before}).energy / volume;
    };
    EXPECT_NEAR(pressure(0.5, false), 2e3, 1e-9);
    EXPECT_NEAR(pressure(1.0, true), 4e3, 1e-9);
    EXPECT_NEAR(pressure(1.0, false), 1e3, 1e-9);
    EXPECT_EQ(element->jumps(), std::vector<double>{1.0});
    EXPECT_TRUE(element->steady(1.0, 5.0));
    EXPECT_FALSE(element->steady(0.0, 0.5));
    EXPECT_TRUE(element->has_potential());
    EXPECT_FALSE(element->depends_on_velocity());
}

}  // namespace
}  // namespace myo::model::cavity_pressure_tests
