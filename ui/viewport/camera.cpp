#include "viewport/camera.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace myo::ui::viewport {

CameraAxes camera_axes(const Camera& c) {
    CameraAxes axes;
    axes.back = {std::cos(c.pitch) * std::cos(c.yaw), std::cos(c.pitch) * std::sin(c.yaw), std::sin(c.pitch)};
    axes.right = {-std::sin(c.yaw), std::cos(c.yaw), 0.0};
    axes.up = axes.back.cross(axes.right);
    return axes;
}

// A parallel projection has no eye point. Six scene radii of extra distance put the whole scene in front of it.
double eye_distance(const Camera& c) { return c.orthographic ? c.distance + 6.0 * c.scene_radius : c.distance; }

Eigen::Matrix4d view_matrix(const Camera& c) {
    const CameraAxes axes = camera_axes(c);
    Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
    view.block<1, 3>(0, 0) = axes.right.transpose();
    view.block<1, 3>(1, 0) = axes.up.transpose();
    view.block<1, 3>(2, 0) = axes.back.transpose();
    view.block<3, 1>(0, 3) = -view.block<3, 3>(0, 0) * (c.target + eye_distance(c) * axes.back);
    return view;
}

Eigen::Matrix4d projection_matrix(const Camera& c, const ViewSize& size) {
    // The clipping planes follow the scene: a fixed near plane would waste depth resolution, or cut bodies of another
    // size.
    const double near = std::max(c.distance - 3.0 * c.scene_radius, 0.01 * c.distance);
    const double far = c.distance + 6.0 * c.scene_radius;
    const double f = 1.0 / std::tan(0.5 * c.field_of_view);
    Eigen::Matrix4d projection = Eigen::Matrix4d::Zero();
    // At the target both projections have the same scale, so switching between them keeps the size of the body.
    if (c.orthographic) {
        const double depth = eye_distance(c) + 6.0 * c.scene_radius;  // of the visible space, from the eye
        projection(1, 1) = f / c.distance;
        projection(0, 0) = projection(1, 1) / size.aspect();
        projection(2, 2) = -2.0 / depth;
        projection(2, 3) = -1.0;
        projection(3, 3) = 1.0;
        return projection;
    }
    projection(0, 0) = f / size.aspect();
    projection(1, 1) = f;
    projection(2, 2) = (far + near) / (near - far);
    projection(2, 3) = 2.0 * far * near / (near - far);
    projection(3, 2) = -1.0;
    return projection;
}

std::optional<Eigen::Vector3d> project(const Camera& c, const ViewSize& size, const Eigen::Vector3d& point) {
    const Eigen::Vector4d seen = view_matrix(c) * point.homogeneous();
    // A point at the eye or behind it has no pixel.
    if (seen.z() >= -1e-9) return std::nullopt;
    const Eigen::Vector4d clip = projection_matrix(c, size) * seen;
    return Eigen::Vector3d(0.5 * (1.0 + clip.x() / clip.w()) * size.width,
                           0.5 * (1.0 - clip.y() / clip.w()) * size.height, -seen.z());
}

double metres_per_pixel(const Camera& c, const ViewSize& size) {
    return 2.0 * c.distance * std::tan(0.5 * c.field_of_view) / size.height;
}

Camera orbit(Camera c, double dx, double dy) {
    constexpr double radians_per_pixel = 0.008;
    // The pitch stops 1e-3 rad before the poles, so that z keeps pointing upwards in the image.
    constexpr double pole = 0.5 * std::numbers::pi - 1e-3;
    c.yaw = std::remainder(c.yaw - radians_per_pixel * dx, 2.0 * std::numbers::pi);
    c.pitch = std::clamp(c.pitch + radians_per_pixel * dy, -pole, pole);
    return c;
}

Camera pan(Camera c, const ViewSize& size, double dx, double dy) {
    const CameraAxes axes = camera_axes(c);
    c.target += metres_per_pixel(c, size) * (-dx * axes.right + dy * axes.up);
    return c;
}

Camera zoom(Camera c, const ViewSize& size, double factor, const Eigen::Vector2d& cursor) {
    // The limits keep the camera from passing through the target or losing the scene.
    const double distance = std::clamp(c.distance * factor, 0.02 * c.scene_radius, 50.0 * c.scene_radius);
    const double applied = distance / c.distance;
    const CameraAxes axes = camera_axes(c);
    const Eigen::Vector2d from_center = cursor - 0.5 * Eigen::Vector2d(size.width, size.height);
    const double scale = metres_per_pixel(c, size);
    c.target += (1.0 - applied) * scale * (from_center.x() * axes.right - from_center.y() * axes.up);
    c.distance = distance;
    return c;
}

Camera fit(Camera c, const ViewSize& size, const Box& box) {
    c.target = 0.5 * (box.lowest + box.highest);
    c.scene_radius = std::max(0.5 * box.size().norm(), 1e-6);
    // Each corner of the box requires a distance at which it stays inside the view with a margin of 30 %; the largest
    // one counts.
    const CameraAxes axes = camera_axes(c);
    const double tan_y = std::tan(0.5 * c.field_of_view);
    const double tan_x = tan_y * size.aspect();
    double distance = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3d p(corner & 1 ? box.highest.x() : box.lowest.x(),
                                corner & 2 ? box.highest.y() : box.lowest.y(),
                                corner & 4 ? box.highest.z() : box.lowest.z());
        const Eigen::Vector3d d = p - c.target;
        const double towards_eye = d.dot(axes.back);
        distance = std::max({distance, towards_eye + 1.3 * std::abs(d.dot(axes.right)) / tan_x,
                             towards_eye + 1.3 * std::abs(d.dot(axes.up)) / tan_y});
    }
    c.distance = std::max(distance, 1e-6);
    return c;
}

Camera turn_to(Camera c, StandardView view) {
    constexpr double quarter = 0.5 * std::numbers::pi;
    switch (view) {
        case StandardView::oblique:
            c.yaw = -1.0;
            c.pitch = 0.4;
            break;
        case StandardView::from_x:
            c.yaw = 0.0;
            c.pitch = 0.0;
            break;
        case StandardView::from_y:
            c.yaw = -quarter;
            c.pitch = 0.0;
            break;
        // The greatest pitch that orbit() allows.
        case StandardView::from_z:
            c.yaw = -quarter;
            c.pitch = quarter - 1e-3;
            break;
    }
    return c;
}

Camera turn_to_or_round(const Camera& camera, StandardView view) {
    Camera turned = turn_to(camera, view);
    if (!(turned == camera)) return turned;
    if (view == StandardView::from_z)
        turned.pitch = -turned.pitch;
    else
        turned.yaw += std::numbers::pi;
    return turned;
}

}  // namespace myo::ui::viewport
