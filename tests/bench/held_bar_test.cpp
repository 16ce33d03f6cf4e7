#include "bench/held_bar.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "bench/bar_meshes.hpp"
#include "bench/beam_statics.hpp"
#include "bench/kept_cells.hpp"
#include "bench/published_beam.hpp"
#include "mesh/box_mesh.hpp"

// Meshes, loads and small motions of the bars of the benchmarks.

namespace myo::bench::held_bar_test {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr Skew every_skew[] = {Skew::none, Skew::plan, Skew::side, Skew::nodes};
constexpr fem::ElementKind every_element[] = {fem::ElementKind::hex8, fem::ElementKind::tet4, fem::ElementKind::tet10};

BarShape short_bar() {
    BarShape bar;
    bar.length_m = 0.04;
    bar.width_m = 0.012;
    bar.height_m = 0.01;
    return bar;
}

const Eigen::Vector3i few_bricks(5, 2, 2);

TEST(BarMesh, EveryDistortionFillsTheBarAndKeepsItsEnds) {
    const BarShape bar = short_bar();
    for (const fem::ElementKind element : every_element)
        for (const Skew skew : every_skew) {
            const mesh::VolumeMesh mesh = bar_mesh(bar, element, few_bricks, skew);
            const std::string what = to_string(element) + " " + name_of(skew);
            const Eigen::VectorXd volumes = mesh::cell_volumes(mesh);
            if (skew != Skew::nodes) {
                EXPECT_GT(volumes.minCoeff(), 0.0) << what;
            }
            EXPECT_NEAR(volumes.sum() / (0.04 * 0.012 * 0.01), 1.0, 1e-10) << what;
            const Box box = mesh::bounding_box(mesh.nodes);
            EXPECT_LT(box.lowest.norm() + (box.highest - Vector3d(0.04, 0.012, 0.01)).norm(), 1e-12) << what;
            // As many nodes on either end as an even mesh has there.
            const mesh::VolumeMesh even = bar_mesh(bar, element, few_bricks);
            for (const double x : {0.0, 0.04})
                EXPECT_EQ(((mesh.nodes.row(0).array() - x).abs() < 1e-12).count(),
                          ((even.nodes.row(0).array() - x).abs() < 1e-12).count())
                    << what;
        }
}

TEST(BarMesh, DistortionsMoveInnerNodesReproducibly) {
    const BarShape bar = short_bar();
    const Matrix3Xd even = bar_mesh(bar, fem::ElementKind::hex8, few_bricks).nodes,
                    plan = bar_mesh(bar, fem::ElementKind::hex8, few_bricks, Skew::plan).nodes,
                    side = bar_mesh(bar, fem::ElementKind::hex8, few_bricks, Skew::side).nodes,
                    nodes = bar_mesh(bar, fem::ElementKind::hex8, few_bricks, Skew::nodes).nodes;
    EXPECT_EQ(nodes, bar_mesh(bar, fem::ElementKind::hex8, few_bricks, Skew::nodes).nodes);
    // Shears move along x only: where y, or z, is off the middle.
    for (const auto& [sheared, axis, extent] : {std::tuple{&plan, 1, 0.012}, std::tuple{&side, 2, 0.01}}) {
        EXPECT_EQ(sheared->bottomRows(2), even.bottomRows(2));
        EXPECT_GT((*sheared - even).norm(), 1e-3);
        for (Eigen::Index i = 0; i < even.cols(); ++i)
            if (std::abs(even(axis, i) - 0.5 * extent) < 1e-9) {
                EXPECT_NEAR((*sheared)(0, i), even(0, i), 1e-15);
            }
    }
    const Vector3d most = 0.2 * Vector3d(0.04 / 5, 0.012 / 2, 0.01 / 2);
    for (int axis = 0; axis < 3; ++axis) {
        const double largest = (nodes - even).row(axis).cwiseAbs().maxCoeff();
        EXPECT_LE(largest, most(axis));
        EXPECT_GT(largest, 0.5 * most(axis));
    }
}

TEST(BarMesh, BricksHaveTheAskedProportions) {
    BarShape bar = short_bar();
    EXPECT_EQ(bar_bricks(bar, 2, 1.0), Eigen::Vector3i(8, 2, 2));
    EXPECT_EQ(bar_bricks(bar, 2, 2.0), Eigen::Vector3i(4, 2, 2));
    EXPECT_EQ(bar_bricks(bar, 3, 1.0), Eigen::Vector3i(12, 3, 3));
    bar.length_m = 0.0449;
    EXPECT_EQ(bar_bricks(bar, 1, 1.0)(0), 4);
    EXPECT_EQ(name_of(Skew::none), "");
    EXPECT_NE(name_of(Skew::plan), name_of(Skew::side));
}

TEST(KeptCells, KeepTheirShapeAndOnlyTheirNodes) {
    const mesh::VolumeMesh whole = bar_mesh(short_bar(), fem::ElementKind::tet10, few_bricks);
    const mesh::VolumeMesh all = kept_cells(whole, [](const Vector3d&) { return true; }),
                           half = kept_cells(whole, [](const Vector3d&middle) { return middle.x() < 0.016; }),
                           none = kept_cells(whole, [](const Vector3d&) { return false; });
    EXPECT_EQ(all.type, whole.type);
    EXPECT_EQ(all.node_count(), whole.node_count());
    EXPECT_EQ(mesh::cell_volumes(all), mesh::cell_volumes(whole));
    EXPECT_NEAR(mesh::cell_volumes(half).sum(), 0.016 * 0.012 * 0.01, 1e-15);
    EXPECT_LT(half.nodes.row(0).maxCoeff(), 0.016 + 1e-12);
    EXPECT_EQ(half.cells.maxCoeff() + 1, half.node_count());
    // Numbers in the order of first use: the largest so far grows by one at most.
    int next = 0;
    for (const int node : half.cells.reshaped()) {
        EXPECT_LE(node, next);
        next = std::max(next, node + 1);
    }
    EXPECT_EQ(none.cell_count() + none.node_count(), 0);
    EXPECT_EQ(none.cells.rows(), whole.cells.rows());
}

TEST(HeldBar, LoadsOfTheFreeEndAreAForceAndATorque) {
    for (const fem::ElementKind element : every_element) {
        const model::Model model = held_bar(short_bar(), element, bar_mesh(short_bar(), element, few_bricks));
        const Matrix3Xd& X = model.body->mesh.nodes;
        const Eigen::VectorXd share = free_end_share(*model.body);
        EXPECT_NEAR(share.sum(), 1.0, 1e-12);
        // A uniform load acts at the middle of the end.
        EXPECT_LT((X * share - Vector3d(0.04, 0.006, 0.005)).norm(), 1e-12);
        const Matrix3Xd torque = unit_torque(*model.body);
        EXPECT_LT(torque.rowwise().sum().norm(), 1e-9) << "a pure torque";
        Vector3d moment = Vector3d::Zero();
        for (Eigen::Index i = 0; i < X.cols(); ++i) moment += X.col(i).head<3>().cross(torque.col(i).head<3>());
        EXPECT_LT((moment - Vector3d::UnitX()).norm(), 1e-9);
        // The work on a small turn of the whole body is the angle, wherever the axis is.
        Matrix3Xd turned = X;
        for (auto x : turned.colwise()) x = Vector3d::UnitX().cross(Vector3d(x) - Vector3d(0.0, 0.3, -0.2));
        EXPECT_NEAR(torque.cwiseProduct(turned).sum(), 1.0, 1e-9);
    }
}

/// Betti: the work of one load on the displacements of another is that of the other on those of the first.
TEST(HeldBar, SmallMotionsAreLinearAndReciprocal) {
    const BarShape bar = short_bar();
    const model::Model model = held_bar(bar, fem::ElementKind::hex8, bar_mesh(bar, fem::ElementKind::hex8, few_bricks));
    SmallMotions motions(model);
    const Matrix3Xd& weight = motions.weight_N();
    EXPECT_NEAR(weight.row(2).sum(), -1070.0 * 0.04 * 0.012 * 0.01, 1e-9);
    EXPECT_EQ(weight.topRows(2).norm(), 0.0);
    const Matrix3Xd torque = 1e-4 * unit_torque(*model.body), sag = motions.under(weight),
                    twist = motions.under(torque);
    EXPECT_LT(sag.row(2).minCoeff(), 0.0);
    for (Eigen::Index i = 0; i < sag.cols(); ++i)
        if (model.body->mesh.nodes(0, i) == 0.0) {
            EXPECT_EQ(sag.col(i).norm() + twist.col(i).norm(), 0.0) << "held";
        }
    const Matrix3Xd pull = Vector3d(1e-3, 2e-3, 3e-3) * free_end_share(*model.body).transpose();
    const double one = pull.cwiseProduct(sag).sum(), other = weight.cwiseProduct(motions.under(pull)).sum();
    EXPECT_NEAR(one / other, 1.0, 1e-4);
    EXPECT_LT((motions.under(2.0 * weight - torque) - (2.0 * sag - twist)).norm(), 1e-3 * sag.norm());
}

/// Rayleigh: the frequency of the static shape is an upper bound of that of the mode, and close to it.
TEST(HeldBar, TheFirstModeIsBelowRayleighsEstimate) {
    BarShape bar = short_bar();
    bar.width_m = 0.02;
    const model::Model model = held_bar(bar, fem::ElementKind::hex8, bar_mesh(bar, fem::ElementKind::hex8, few_bricks));
    SmallMotions motions(model);
    const Matrix3Xd sag = motions.under(motions.weight_N());
    const Matrix3Xd inertia = model::times_mass(sag, model::mass_matrix(model));
    const double estimate = std::sqrt(sag.cwiseProduct(motions.weight_N()).sum() / sag.cwiseProduct(inertia).sum());
    const BendingMode mode = motions.first_bending();
    EXPECT_LE(mode.omega_rad_s, estimate * (1.0 + 1e-6));
    EXPECT_GT(mode.omega_rad_s, 0.97 * estimate);
    // Nearly all of the energy of a body that hardly changes its volume is deviatoric.
    EXPECT_GT(mode.damping_factor, 0.9);
    EXPECT_LE(mode.damping_factor, 1.001);
}

TEST(PublishedBeam, TheEdgeForceIsSharedByItsNodes) {
    const mesh::VolumeMesh mesh = mesh::box_hex_mesh({Vector3d::Zero(), Vector3d(0.2, 0.06, 0.04)}, {4, 3, 2});
    const model::DeadForce force = force_on_upper_tip_edge(mesh, -2.5);
    EXPECT_EQ(force.force_N, Vector3d(0.0, 0.0, -2.5));
    EXPECT_NEAR(force.share.sum(), 1.0, 1e-15);
    for (Eigen::Index i = 0; i < mesh.node_count(); ++i)
        EXPECT_NEAR(force.share(i), mesh.nodes(0, i) > 0.199 && mesh.nodes(2, i) > 0.039 ? 0.25 : 0.0, 1e-15);
}

TEST(PublishedBeam, TheNodeIsOneCellBelowTheUpperCornerOfTheTip) {
    const model::Model beam = published_beam({.file = "", .edge_m = 0.1 / 10.9});
    const mesh::VolumeMesh& mesh = beam.body->mesh;
    EXPECT_EQ(mesh.cell_count(), 10 * 3 * 3);
    const double edge = 0.1 / 10.9;
    EXPECT_LT((mesh.nodes.col(published_node(mesh)) - Vector3d(0.0, 0.0, 2.0 * edge)).norm(), 1e-9);
    EXPECT_TRUE(beam.forces.empty());
    EXPECT_EQ(published_beam({.file = "", .edge_m = edge, .tip_force_N = -1.0}).forces.size(), 1u);
}

TEST(PublishedBeam, DeviationsAreSharesOfTheDeflection) {
    NodeTrace trace{{0.0, 0.1}, Matrix3Xd::Zero(3, 2)};
    trace.positions.col(1) << 0.0, 0.0, -0.02;
    dynamics::Trace run;
    run.times_s = {0.0, 0.1, 0.2};
    run.positions.assign(3, Matrix3Xd::Zero(3, 2));
    run.positions[1].col(1) << 0.003, 0.0, -0.024;
    EXPECT_NEAR(trace_deviation(run, 1, trace), 0.25, 1e-12);
    EXPECT_NEAR(trace_deviation(run, 0, trace), 1.0, 1e-12);
}

TEST(BenchBeam, TheTipIsTheLowerEdgeOfTheEnd) {
    const model::Model model = bench_beam({.element = fem::ElementKind::hex8, .cells = {4, 2, 2}});
    const Matrix3Xd& X = model.body->mesh.nodes;
    EXPECT_LT((tip_displacement(model, X.colwise() + Vector3d(1, 2, 3)) - Vector3d(1, 2, 3)).norm(), 1e-12);
    // Stretched threefold about the origin, the edge at x = 0.1, z = 0 moves by twice its own place.
    EXPECT_LT((tip_displacement(model, 3.0 * X) - Vector3d(0.2, 0.03, 0.0)).norm(), 1e-12);
    EXPECT_TRUE(model.forces.empty());
    const model::Model loaded = bench_beam({.cells = {4, 2, 2}, .tip_force_N = 0.5});
    ASSERT_EQ(loaded.forces.size(), 1u);
    EXPECT_NEAR(loaded.forces[0].share.sum(), 1.0, 1e-12);
    EXPECT_EQ(loaded.forces[0].force_N, Vector3d(0.0, 0.0, 0.5));
}

}  // namespace
}  // namespace myo::bench::held_bar_test
