#pragma once

#include <Eigen/Core>

#include <optional>

#include "mesh/surface_mesh.hpp"

namespace myo::ui::viewport {

/// Turntable camera with z upwards. Lengths in metres, angles in radians, world frame. A plain value: all operations
/// below return a changed copy.
struct Camera {
    Eigen::Vector3d target = Eigen::Vector3d::Zero();  // point that the camera looks at and turns around [m]
    double distance = 1.0;                             // from eye to target [m]
    double yaw = -1.0;                                 // of the eye about z [rad]; 0 = looking from +x
    double pitch = 0.4;                                // of the eye above the horizon [rad]
    double field_of_view = 0.5;                        // vertical [rad]
    double scene_radius = 1.0;                         // half the diagonal of the scene [m]; sets the clipping planes
    bool orthographic = false;  // parallel projection, with the same scale at the target as the perspective one

    bool operator==(const Camera&) const = default;
};

/// Size of a view in the window [pixels]. Both sides are at least 1 in a view that is drawn.
struct ViewSize {
    int width = 1;
    int height = 1;

    double aspect() const { return static_cast<double>(width) / static_cast<double>(height); }
    bool operator==(const ViewSize&) const = default;
};

/// Unit vectors of the view, in the world frame.
struct CameraAxes {
    Eigen::Vector3d right;  // to the right in the image
    Eigen::Vector3d up;     // upwards in the image
    Eigen::Vector3d back;   // from the target to the eye
};
/// Axes of the camera's view, from its yaw and pitch.
CameraAxes camera_axes(const Camera& camera);

/// Distance from the eye to the target [m]. For a parallel projection the eye is placed far enough back to have the
/// whole scene in front of it.
double eye_distance(const Camera& camera);

/// World to view coordinates: x right, y up, z towards the eye.
Eigen::Matrix4d view_matrix(const Camera& camera);
/// View to clip coordinates as OpenGL expects them, depth from -1 to 1.
Eigen::Matrix4d projection_matrix(const Camera& camera, const ViewSize& size);

/// Projects a world point [m].
///
/// @return x, y in pixels from the upper left corner of the view; z is the distance in front of the eye [m]. Empty if
///         the point lies behind the eye.
std::optional<Eigen::Vector3d> project(const Camera& camera, const ViewSize& size, const Eigen::Vector3d& point);

/// Length [m] that one pixel covers at the distance of the target.
double metres_per_pixel(const Camera& camera, const ViewSize& size);

/// Turns the camera by a mouse drag of (dx, dy) pixels. The pitch is limited just before the poles.
Camera orbit(Camera camera, double dx, double dy);
/// Moves the target in the image plane, so that the point under the cursor follows a drag of (dx, dy) pixels.
Camera pan(Camera camera, const ViewSize& size, double dx, double dy);
/// Multiplies the distance by `factor`. The point of the target plane under `cursor` (pixels from the upper left) keeps
/// its place in the image.
Camera zoom(Camera camera, const ViewSize& size, double factor, const Eigen::Vector2d& cursor);
/// Moves target and distance so that the whole box [m] is visible; the direction stays. Also sets scene_radius.
Camera fit(Camera camera, const ViewSize& size, const Box& box);

/// Directions of the view buttons.
enum class StandardView { oblique, from_x, from_y, from_z };
/// Turns the camera to look from a standard direction: oblique, from +x, from -y, or from +z. Target and distance stay.
Camera turn_to(Camera camera, StandardView view);
/// As turn_to(), but looks from the opposite side if the camera already has the standard direction.
Camera turn_to_or_round(const Camera& camera, StandardView view);

}  // namespace myo::ui::viewport
