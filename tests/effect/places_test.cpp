#include "effect/places.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "effect/changed_body.hpp"
#include "mesh/region.hpp"
#include "model/held_nodes.hpp"
#include "model/loaded_face.hpp"
#include "support/meshes.hpp"

namespace myo::effect::places_tests {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// A body of 0.12 x 0.04 x 0.06 m in cells of 20 mm whose nodes in a box are held.
TrialContext held_in(const Box& box, fem::ElementKind kind = fem::ElementKind::hex8) {
    TrialContext context;
    mesh::VolumeMesh mesh = test::box_mesh(kind, {Vector3d::Zero(), {0.12, 0.04, 0.06}}, {6, 2, 3});
    const std::vector<int> nodes = mesh::nodes_in_box(mesh, box);
    context.body = model::make_body(std::move(mesh), kind, nodes);
    context.held = box;
    return context;
}
const Box nowhere{{9.0, 9.0, 9.0}, {9.1, 9.1, 9.1}};
Box slab(int axis, double low, double high) {
    Box box{Vector3d::Constant(-1.0), Vector3d::Constant(1.0)};
    box.lowest(axis) = low;
    box.highest(axis) = high;
    return box;
}

TEST(ClampAxis, PointsFromTheClampToTheFreeEnd) {
    struct Case {
        Box box;
        int axis;
        double sign, begin_m, length_m, held_m;
    };
    for (const Case& c : {Case{slab(0, -1.0, 0.0), 0, 1.0, 0.0, 0.12, 0.0},
                          {slab(0, -1.0, 0.041), 0, 1.0, 0.04, 0.08, 0.04},
                          {slab(0, 0.119, 1.0), 0, -1.0, 0.12, 0.12, 0.0},
                          {slab(0, 0.079, 1.0), 0, -1.0, 0.08, 0.08, 0.04},
                          {slab(1, -1.0, 0.0), 1, 1.0, 0.0, 0.04, 0.0},
                          {slab(2, 0.039, 1.0), 2, -1.0, 0.04, 0.04, 0.02}}) {
        const ClampAxis axis = clamp_axis(held_in(c.box));
        EXPECT_EQ(axis.axis, c.axis);
        EXPECT_EQ(axis.sign, c.sign);
        EXPECT_NEAR(axis.begin_m, c.begin_m, 1e-12);
        EXPECT_NEAR(axis.length_m, c.length_m, 1e-12);
        EXPECT_NEAR(axis.held_m, c.held_m, 1e-12);
        // Ahead of the clamp distances are positive, up to the length; at the held nodes they are not.
        const TrialContext context = held_in(c.box);
        double farthest = -1.0;
        for (int i = 0; i < context.body->node_count(); ++i) {
            const double ahead = axis.ahead(context.body->mesh.nodes.col(i));
            farthest = std::max(farthest, ahead);
            EXPECT_EQ(ahead > 1e-12, !context.body->clamped[static_cast<std::size_t>(i)]);
        }
        EXPECT_NEAR(farthest, axis.length_m, 1e-12);
    }
}

/// What counts is how far off the middle the clamp is for the size of the body there.
TEST(ClampAxis, IsThatOfTheLargestRelativeOffset) {
    // Held at the lower half of one end: 60 mm of 120 along x, and 20 of 60 along z.
    const ClampAxis axis = clamp_axis(held_in({{-1.0, -1.0, -1.0}, {0.0, 1.0, 0.021}}));
    EXPECT_EQ(axis.axis, 0);
    // Held on the lower side of the half near x = 0: an offset of a half along z, of a quarter along x.
    const ClampAxis below = clamp_axis(held_in({{-1.0, -1.0, -1.0}, {0.061, 1.0, 0.0}}));
    EXPECT_EQ(below.axis, 2);
    EXPECT_EQ(below.sign, 1.0);
}

TEST(CellCentres, AreTheMeansOfTheirNodes) {
    const TrialContext context = held_in(nowhere);
    const Matrix3Xd centres = cell_centres(*context.body);
    ASSERT_EQ(centres.cols(), 36);
    EXPECT_LT((centres.rowwise().mean() - Vector3d(0.06, 0.02, 0.03)).norm(), 1e-14);
    EXPECT_NEAR(centres.row(0).minCoeff(), 0.01, 1e-15);
    EXPECT_NEAR(centres.row(2).maxCoeff(), 0.05, 1e-15);
}

/// Smallest distance between two of the points.
double spacing(const std::vector<Vector3d>& points) {
    double least = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) least = std::min(least, (points[i] - points[j]).norm());
    return least;
}

TEST(SpreadCells, BeginsFarFromTheClampAndFillsTheBody) {
    const TrialContext context = held_in(slab(0, -1.0, 0.0));
    const std::vector<Vector3d> all = spread_cells(context, 1000);
    ASSERT_EQ(all.size(), 36u) << "no more than there are";
    EXPECT_GT(spacing(all), 0.0199) << "each once";
    EXPECT_NEAR(all[0].x(), 0.11, 1e-12);
    EXPECT_NEAR(all[1].x(), 0.01, 1e-12) << "then at the other end";
    EXPECT_TRUE(spread_cells(context, 0).empty());
    const Matrix3Xd centres = cell_centres(*context.body);
    for (const std::size_t count : {1u, 2u, 4u, 9u}) {
        const std::vector<Vector3d> some = spread_cells(context, count);
        ASSERT_EQ(some.size(), count);
        for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(some[i], all[i]) << "fewer are the first of more";
        // No cell is farther from the chosen ones than these are from each other.
        if (count < 2) continue;
        for (Eigen::Index c = 0; c < centres.cols(); ++c) {
            double nearest = std::numeric_limits<double>::max();
            for (const Vector3d& at : some) nearest = std::min(nearest, (centres.col(c) - at).norm());
            EXPECT_LE(nearest, spacing(some) + 1e-12);
        }
    }
}

TEST(SpreadSurfacePoints, LieOnFreeFaces) {
    for (const fem::ElementKind kind : {fem::ElementKind::hex8, fem::ElementKind::tet10}) {
        const TrialContext context = held_in(slab(0, -1.0, 0.0), kind);
        const std::vector<Vector3d> points = spread_surface_points(context, 10);
        ASSERT_EQ(points.size(), 10u);
        EXPECT_GT(spacing(points), 0.02);
        for (const Vector3d& at : points) {
            EXPECT_GT(at.x(), 1e-6) << "the held face is left out";
            const Vector3d beside = at.cwiseMin(Vector3d(0.12, 0.04, 0.06) - at);
            EXPECT_NEAR(beside.minCoeff(), 0.0, 1e-12);
        }
        EXPECT_EQ(spread_surface_points(context, 100000).size(), model::free_faces(*context.body).size());
    }
}

/// Normals point out of the body, and the nearest point of a surface to one beside a face is its foot.
TEST(SurfacePlace, HasTheFootAndTheOutwardNormal) {
    for (const fem::ElementKind kind : {fem::ElementKind::hex8, fem::ElementKind::tet4, fem::ElementKind::tet10}) {
        const TrialContext context = held_in(nowhere, kind);
        const Vector3d size(0.12, 0.04, 0.06);
        for (int axis = 0; axis < 3; ++axis)
            for (const bool is_high : {false, true}) {
                Vector3d foot(0.047, 0.013, 0.028), outward = Vector3d::Zero();
                foot(axis) = is_high ? size(axis) : 0.0;
                outward(axis) = is_high ? 1.0 : -1.0;
                for (const double off : {0.0, 0.005, 0.5, -0.005}) {
                    const SurfacePlace place = surface_place(*context.body, foot + off * outward);
                    EXPECT_LT((place.point - foot).norm(), 1e-8) << off;
                    EXPECT_LT((place.normal - outward).norm(), 1e-12) << off;
                    // The nodes are of the cell behind, on the face.
                    const auto cell = context.body->mesh.cells.col(place.cell);
                    for (const int node : place.nodes) {
                        EXPECT_NE(std::find(cell.begin(), cell.end(), node), cell.end());
                        EXPECT_NEAR(context.body->mesh.nodes(axis, node), foot(axis), 1e-12);
                    }
                }
            }
        // At a node the point is the node.
        const SurfacePlace corner = surface_place(*context.body, {0.2, 0.1, 0.1});
        EXPECT_LT((corner.point - size).norm(), 1e-8);
        EXPECT_NEAR(corner.shares.maxCoeff(), 1.0, 1e-6);
    }
}

TEST(ChangedBody, KeepsWhatIsNotChanged) {
    const TrialContext context = held_in(slab(0, -1.0, 0.021));
    const model::Body& body = *context.body;
    const std::vector<int> held = model::held_nodes(body);
    ASSERT_EQ(held.size(), 24u);
    const model::BodyPointer released = released_body(body, {held[0], held[5]});
    EXPECT_EQ(model::held_nodes(*released).size(), 22u);
    EXPECT_EQ(released->pattern.free_count, body.pattern.free_count + 2);
    EXPECT_EQ(model::held_nodes(body).size(), 24u) << "the body that was given is left";
    const model::BodyPointer longer = on_nodes(body, Vector3d(2.0, 1.0, 1.0).asDiagonal() * body.mesh.nodes);
    EXPECT_NEAR(longer->volume_m3, 2.0 * body.volume_m3, 1e-15);
    EXPECT_NEAR(longer->unit_mass.sum(), 2.0 * body.volume_m3, 1e-15);
    EXPECT_EQ(longer->clamped, body.clamped);
    EXPECT_EQ(longer->kind, body.kind);
    const model::BodyPointer full = of_kind(body, fem::ElementKind::hex8_full);
    EXPECT_EQ(full->kind, fem::ElementKind::hex8_full);
    EXPECT_EQ(full->clamped, body.clamped);
    EXPECT_EQ(full->mesh.nodes, body.mesh.nodes);
}

}  // namespace
}  // namespace myo::effect::places_tests
