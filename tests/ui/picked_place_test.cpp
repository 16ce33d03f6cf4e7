#include "commands/picked_place.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mesh/box_mesh.hpp"

// What a click in the view means: markers and points of a body of three cells, seen from -y.

namespace myo::ui::picked_place {
namespace {

using commands::PickedPlace;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
const Box body_box{{0.0, 0.0, 0.0}, {0.09, 0.03, 0.03}};

/// The body, drawn `shift` away from its rest shape, with the camera before its side y = 0.
struct PickedView {
    explicit PickedView(const Vector3d& shift = Vector3d::Zero()) {
        auto body = std::make_shared<commands::MeshedBody>();
        body->mesh = mesh::box_hex_mesh(body_box, {3, 1, 1});
        body->boundary = mesh::boundary_faces(body->mesh);
        drawn.body = std::make_shared<viewport::DrawnBody>(viewport::DrawnBody{body->boundary, {}});
        drawn.surface = std::make_shared<viewport::DrawnSurface>(viewport::drawn_surface(body->boundary));
        drawn.positions = body->mesh.nodes.colwise() + shift;
        state.body = body;
        camera = viewport::turn_to(viewport::fit(camera, size, body_box), viewport::StandardView::from_y);
        camera.orthographic = true;
    }
    Vector2d pixel(const Vector3d& place) const { return viewport::project(camera, size, place)->head<2>(); }
    std::optional<PickedPlace> pick(const Vector2d& at, double reach = 8.0) const {
        return commands::pick_place(state, drawn, camera, size, at, reach);
    }
    std::optional<std::size_t> pick_of(const std::vector<Vector3d>& places, const Vector2d& at,
                                       double reach = 8.0) const {
        return commands::pick_one(places, drawn, camera, size, at, reach);
    }
    void add_marker(int number, const Vector3d& place, bool ring = false) {
        viewport::DrawnMarker marker;
        marker.position = place;
        marker.number = number;
        marker.ring = ring;
        drawn.markers.push_back(marker);
    }

    const viewport::ViewSize size{800, 600};
    viewport::Camera camera;
    commands::WorkbenchState state;
    viewport::DrawnScene drawn;
};

TEST(PickOne, TakesTheNearestWithinReach) {
    const PickedView view;
    const std::vector<Vector3d> places{{0.02, 0.0, 0.02}, {0.07, 0.0, 0.02}};
    const Vector2d first = view.pixel(places[0]);
    EXPECT_EQ(view.pick_of(places, first), 0u);
    EXPECT_EQ(view.pick_of(places, view.pixel(places[1])), 1u);
    // Three to the right and four down are five.
    EXPECT_EQ(view.pick_of(places, first + Vector2d(3.0, 4.0), 5.001), 0u);
    EXPECT_EQ(view.pick_of(places, first + Vector2d(3.0, 4.0), 4.999), std::nullopt);
    const Vector2d between = 0.4 * first + 0.6 * view.pixel(places[1]);
    EXPECT_EQ(view.pick_of(places, between, 1e4), 1u) << "both are in reach, and the second is nearer";
    EXPECT_EQ(view.pick_of({}, first), std::nullopt);
}

TEST(PickOne, WhatTheBodyHidesComesAfterWhatIsSeen) {
    const PickedView view;
    // On the far side of the body, and a little beside it on the near one.
    const Vector3d hidden(0.05, 0.03, 0.015), seen(0.052, 0.0, 0.015);
    EXPECT_EQ(view.pick_of({hidden, seen}, view.pixel(hidden), 1e3), 1u);
    EXPECT_EQ(view.pick_of({seen, hidden}, view.pixel(hidden), 1e3), 0u);
    EXPECT_EQ(view.pick_of({hidden}, view.pixel(hidden)), 0u) << "better than nothing";
    // Beside the body nothing hides anything.
    const Vector3d behind(0.05, 0.2, 0.05), before(0.052, -0.1, 0.05);
    EXPECT_EQ(view.pick_of({behind, before}, view.pixel(behind), 1e3), 0u);
}

TEST(PickOne, AMarkerReachesOutOfTheBodyByItsDiameter) {
    PickedView view;
    view.drawn.marker_radius = 1e-3;
    const Vector3d beside(0.052, 0.0, 0.015);
    for (const double depth : {1.99e-3, 2.01e-3}) {
        const Vector3d below(0.05, depth, 0.015);
        EXPECT_EQ(view.pick_of({below, beside}, view.pixel(below), 1e3), depth < 2e-3 ? 0u : 1u) << depth;
    }
}

TEST(PickOne, NothingIsSeenBehindTheEye) {
    PickedView view;
    view.camera.orthographic = false;
    const Vector3d behind = view.camera.target + 2.0 * view.camera.distance * viewport::camera_axes(view.camera).back;
    EXPECT_EQ(view.pick_of({behind, view.camera.target}, {400.0, 300.0}), 1u);
    EXPECT_EQ(view.pick_of({behind}, {400.0, 300.0}, 1e6), std::nullopt);
}

TEST(PickPlace, ThePointOfTheBodyMovesWithItsNodes) {
    const Vector3d shift(2e-3, 3e-3, -1e-3);
    const PickedView view(shift);
    const double places[] = {0.01, 0.05, 0.08};
    for (int cell = 0; cell < 3; ++cell) {
        const Vector3d at_rest(places[cell], 0.0, 0.012), now = at_rest + shift;
        const auto picked = view.pick(view.pixel(now));
        ASSERT_TRUE(picked);
        EXPECT_EQ(picked->marker, -1);
        EXPECT_EQ(picked->cell, cell);
        EXPECT_NEAR(picked->weights.sum(), 1.0, 1e-12);
        EXPECT_LT((commands::place_now(*picked, view.drawn) - now).norm(), 1e-9);
        EXPECT_LT((commands::place_at_rest(*picked, view.state) - at_rest).norm(), 1e-9);
    }
    EXPECT_FALSE(view.pick({2.0, 2.0})) << "beside the body";
}

TEST(PickPlace, TheNearestNodeOfTheFaceIsNamed) {
    const PickedView view;
    for (const Vector3d& corner : {Vector3d(0.03, 0.0, 0.0), Vector3d(0.03, 0.0, 0.03), Vector3d(0.06, 0.0, 0.03)}) {
        // Towards the middle of the middle face, beside its diagonal.
        const Vector3d to_middle = Vector3d(0.045, 0.0, 0.015) - corner;
        const Vector3d near = corner + Vector3d(0.3 * to_middle.x(), 0.0, 0.2 * to_middle.z());
        const auto picked = view.pick(view.pixel(near));
        ASSERT_TRUE(picked);
        EXPECT_LT((view.state.body->mesh.nodes.col(picked->node) - corner).norm(), 1e-12) << corner.transpose();
    }
}

TEST(PickPlace, AMeshThatIsNotDrawnYetIsNotPicked) {
    PickedView view;
    const Vector2d middle = view.pixel({0.05, 0.0, 0.012});
    ASSERT_TRUE(view.pick(middle));
    auto finer = std::make_shared<commands::MeshedBody>();
    finer->mesh = mesh::box_hex_mesh(body_box, {6, 2, 2});
    view.state.body = finer;
    EXPECT_FALSE(view.pick(middle));
    view.state.body.reset();
    EXPECT_FALSE(view.pick(middle));
}

TEST(PickPlace, AMarkerIsPreferredToTheBodyUnlessItIsInside) {
    PickedView view;
    const Vector3d on_side(0.05, 0.0, 0.015);
    view.add_marker(3, on_side);
    const Vector2d at = view.pixel(on_side);
    ASSERT_TRUE(view.pick(at + Vector2d(5.0, 0.0)));
    EXPECT_EQ(view.pick(at + Vector2d(5.0, 0.0))->marker, 3);
    EXPECT_EQ(view.pick(at + Vector2d(9.0, 0.0))->marker, -1) << "out of reach";
    view.drawn.markers[0].position.y() = 0.02;
    EXPECT_EQ(view.pick(at)->marker, -1) << "hidden by the body";
    EXPECT_EQ(view.pick(at)->cell, 1);
}

TEST(PickPlace, MeasuredAndSimulatedMarkersAreToldApart) {
    PickedView view;
    const Vector3d measured(0.02, -0.001, 0.02), simulated(0.021, -0.001, 0.02);
    view.add_marker(1, measured);
    view.add_marker(1, simulated, true);
    view.add_marker(-1, {0.07, -0.001, 0.012});
    view.add_marker(2, {unknown, 0.0, 0.0});
    for (const bool ring : {false, true}) {
        const Vector3d& place = ring ? simulated : measured;
        const auto picked = view.pick(view.pixel(place));
        ASSERT_TRUE(picked);
        EXPECT_EQ(picked->marker, 1);
        EXPECT_EQ(picked->simulated, ring);
        EXPECT_EQ(commands::place_now(*picked, view.drawn), place);
    }
    EXPECT_EQ(view.pick(view.pixel({0.07, -0.001, 0.012}))->cell, 2) << "what has no number cannot be picked";
    PickedPlace gone;
    gone.marker = 4;
    EXPECT_TRUE(commands::place_now(gone, view.drawn).array().isNaN().all());
}

}  // namespace
}  // namespace myo::ui::picked_place
