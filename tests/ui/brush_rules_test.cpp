#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "commands/brush_settings.hpp"
#include "commands/paint_ground.hpp"
#include "mesh/box_mesh.hpp"

// The brush that suits a body, and the data of the body that painting needs.

namespace myo::ui::brush_rules {
namespace {

using commands::BrushDirection;
using commands::BrushMirror;
using commands::BrushSettings;
using Eigen::Vector3d;

const Box beam{{0.0, 0.0, 0.0}, {0.1, 0.03, 0.03}};

TEST(BrushFor, ABodyIsInMultiplesOfHalfAMillimetre) {
    // Diagonal 108.6 mm: 6 % are 6.5 mm. Twice the volume over the area is 13.04 mm: 60 % are 7.8 mm, near 8 mm.
    const BrushSettings brush = commands::brush_for(mesh::box_surface(beam));
    EXPECT_NEAR(brush.radius_m, 6.5e-3, 1e-12);
    EXPECT_NEAR(brush.depth_m, 8e-3, 1e-12);
    for (const double size : {1e-5, 3e-4, 0.0123, 0.7, 20.0}) {
        const BrushSettings scaled = commands::brush_for(mesh::box_surface({Vector3d::Zero(), size * beam.highest}));
        for (const double length : {scaled.radius_m, scaled.depth_m}) {
            EXPECT_GE(length, 5e-4) << "never nothing";
            EXPECT_NEAR(std::remainder(length, 5e-4), 0.0, 1e-12 + 1e-12 * length);
        }
        // Rounding adds at most a quarter of a millimetre.
        EXPECT_NEAR(scaled.radius_m, std::max(5e-4, 0.06 * size * beam.highest.norm()), 2.5e-4 + 1e-12);
    }
}

TEST(BrushFor, APlateIsNotPaintedThrough) {
    // A plate of 2 mm: 40 % of its height are 0.8 mm, near 1 mm.
    const BrushSettings plate = commands::brush_for(mesh::box_surface({{0, 0, 0}, {0.2, 0.2, 0.002}}));
    EXPECT_NEAR(plate.depth_m, 1e-3, 1e-12);
    // What has neither volume nor area has the size of its box.
    mesh::SurfaceMesh open;
    open.vertices = mesh::box_surface(beam).vertices;
    open.triangles.resize(3, 0);
    EXPECT_NEAR(commands::brush_for(open).depth_m, 0.4 * 0.03, 1e-12);
    // Turned inside out a body has a negative volume, which says nothing of its thickness.
    mesh::SurfaceMesh inverted = mesh::box_surface(beam);
    inverted.triangles.row(0).swap(inverted.triangles.row(1));
    EXPECT_NEAR(commands::brush_for(inverted).depth_m, 0.4 * 0.03, 1e-12);
}

TEST(MakeBrush, ReachesTheCellUnderItOnACoarseMesh) {
    commands::PaintGround ground;
    ground.longest_axis = Vector3d(0.0, 0.6, 0.8);
    ground.middle_m = Vector3d(1.0, 2.0, 3.0);
    BrushSettings settings;
    settings.radius_m = 4e-3;
    settings.depth_m = 2e-3;
    settings.falloff = 0.25;
    settings.strength = 0.75;
    for (const double edge_m : {1e-3, 5e-3, 1e-2}) {
        ground.places.edge_m = edge_m;
        const fibre::Brush brush = commands::make_brush(settings, ground, false);
        EXPECT_DOUBLE_EQ(brush.radius_m, std::max(4e-3, 0.6 * edge_m));
        EXPECT_DOUBLE_EQ(brush.depth_m, std::max(2e-3, 0.6 * edge_m));
        EXPECT_EQ(brush.falloff, 0.25);
        EXPECT_EQ(brush.strength, 0.75);
        EXPECT_FALSE(brush.erase);
        EXPECT_FALSE(brush.axis) << "along the stroke";
        EXPECT_FALSE(brush.mirror);
    }
    settings.through = true;
    EXPECT_EQ(commands::make_brush(settings, ground, true).depth_m, std::numeric_limits<double>::infinity());
    EXPECT_TRUE(commands::make_brush(settings, ground, true).erase);
}

TEST(MakeBrush, HasTheAxisAndTheMirrorThatAreChosen) {
    commands::PaintGround ground;
    ground.places.edge_m = 1e-3;
    ground.longest_axis = Vector3d(0.0, 0.6, 0.8);
    ground.middle_m = Vector3d(1.0, 2.0, 3.0);
    BrushSettings settings;
    const std::vector<std::pair<BrushDirection, Vector3d>> directions{{BrushDirection::x, Vector3d::UnitX()},
                                                                      {BrushDirection::y, Vector3d::UnitY()},
                                                                      {BrushDirection::z, Vector3d::UnitZ()},
                                                                      {BrushDirection::longest, ground.longest_axis}};
    for (const auto& [direction, axis] : directions) {
        settings.direction = direction;
        const fibre::Brush brush = commands::make_brush(settings, ground, false);
        ASSERT_TRUE(brush.axis);
        EXPECT_EQ(*brush.axis, axis);
        EXPECT_EQ(commands::fixed_axis(direction, ground), axis);
    }
    // A fill has no stroke, and takes the longest axis.
    EXPECT_EQ(commands::fixed_axis(BrushDirection::stroke, ground), ground.longest_axis);
    const std::vector<std::pair<BrushMirror, Vector3d>> mirrors{
        {BrushMirror::x, Vector3d::UnitX()}, {BrushMirror::y, Vector3d::UnitY()}, {BrushMirror::z, Vector3d::UnitZ()}};
    for (const auto& [mirror, normal] : mirrors) {
        settings.mirror = mirror;
        const fibre::Brush brush = commands::make_brush(settings, ground, false);
        ASSERT_TRUE(brush.mirror);
        EXPECT_EQ(brush.mirror->normal, normal);
        EXPECT_EQ(brush.mirror->point_m, ground.middle_m);
    }
}

TEST(PaintGround, HoldsMiddleVolumesAndTheLongestAxisOfTheMesh) {
    const Box box{{1.0, -2.0, 0.5}, {1.2, -1.0, 0.9}};
    const mesh::VolumeMesh mesh = mesh::box_hex_mesh(box, {1, 5, 2});
    const auto ground = commands::paint_ground(mesh::box_surface(box), mesh);
    ASSERT_TRUE(ground);
    EXPECT_LT((ground->middle_m - Vector3d(1.1, -1.5, 0.7)).norm(), 1e-12);
    EXPECT_NEAR(ground->volumes_m3.sum(), 0.2 * 1.0 * 0.4, 1e-12);
    EXPECT_NEAR(ground->volumes_m3.maxCoeff(), 0.2 * 0.2 * 0.2, 1e-12) << "all alike";
    EXPECT_NEAR(std::abs(ground->longest_axis.y()), 1.0, 1e-6);
    EXPECT_NEAR(ground->places.edge_m, 0.2, 1e-12) << "between the middles of neighbours";
    EXPECT_EQ(ground->neighbours.cols(), 4 * 2 + 5) << "4 along y in each of 2 layers, 5 between the layers";
    std::atomic<bool> cancel = true;
    EXPECT_FALSE(commands::paint_ground(mesh::box_surface(box), mesh, Progress({}, &cancel)));
}

TEST(PaintGround, KnowsTheNormalAtTheNearestPlaceOfTheSurface) {
    const Box box{{0.0, 0.0, 0.0}, {3.0, 2.0, 1.0}};
    const auto ground = commands::paint_ground(mesh::box_surface(box), mesh::box_hex_mesh(box, {3, 2, 1}));
    ASSERT_TRUE(ground);
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            Vector3d place(1.3, 0.9, 0.45);
            const Vector3d outward = side * Vector3d::Unit(axis);
            // A little inside of the side, and beyond it.
            for (const double beyond : {-0.05, 0.5}) {
                place(axis) = (side > 0.0 ? box.highest(axis) : 0.0) + side * beyond;
                EXPECT_LT((commands::outward_at(*ground, place) - outward).norm(), 1e-12) << place.transpose();
            }
        }
    const auto bare = commands::paint_ground({}, mesh::box_hex_mesh(box, {1, 1, 1}));
    ASSERT_TRUE(bare);
    EXPECT_EQ(commands::outward_at(*bare, {1.0, 1.0, 1.0}), Vector3d::UnitZ()) << "without a surface of its own";
}

}  // namespace
}  // namespace myo::ui::brush_rules
