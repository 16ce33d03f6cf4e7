#pragma once

#include <Eigen/Core>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "commands/marker_errors.hpp"
#include "commands/workbench_state.hpp"
#include "viewport/camera.hpp"
#include "viewport/picking.hpp"
#include "viewport/scene.hpp"

namespace myo::ui::commands {

/// Something the user clicked in the view: a marker, or a material point of the body's surface.
struct PickedPlace {
    int marker = -1;                                    // index in the scene; -1: on the body
    bool simulated = false;                             // markers: the simulated one instead of the measured one
    std::array<int, 3> corners{-1, -1, -1};             // nodes of the triangle that contains the point
    Eigen::Vector3d weights = Eigen::Vector3d::Zero();  // barycentric coordinates in the triangle, sum 1
    int node = -1;                                      // node of the face nearest to the point
    int cell = -1;                                      // cell that the face belongs to
};

/// Finds what is visible under a pixel of the view: a marker within `reach` pixels that the body does not hide,
/// otherwise the body. Empty if there is neither.
std::optional<PickedPlace> pick_place(const WorkbenchState& state, const viewport::DrawnScene& scene,
                                      const viewport::Camera& camera, const viewport::ViewSize& size,
                                      const Eigen::Vector2d& pixel, double reach);

/// Where the ray through a pixel meets the drawn body. Empty outside of it, without a mesh, and for the frame in which
/// a new mesh replaces the drawn one.
std::optional<viewport::SurfaceHit> hit_on_body(const WorkbenchState& state, const viewport::DrawnScene& scene,
                                                const viewport::Camera& camera, const viewport::ViewSize& size,
                                                const Eigen::Vector2d& pixel);

/// Finds the point nearest to a pixel within `reach` pixels. Points that the body hides are considered only if no other
/// point is in reach. Empty if none is.
///
/// @param places_m  the points to choose from [m]
/// @return  index in places_m
std::optional<std::size_t> pick_one(const std::vector<Eigen::Vector3d>& places_m, const viewport::DrawnScene& scene,
                                    const viewport::Camera& camera, const viewport::ViewSize& size,
                                    const Eigen::Vector2d& pixel, double reach);

/// Drawn position [m] in this frame. NaN if the marker is not drawn.
Eigen::Vector3d place_now(const PickedPlace& place, const viewport::DrawnScene& scene);
/// Position at rest [m]. Requires that the state still has the picked body or marker.
Eigen::Vector3d place_at_rest(const PickedPlace& place, const WorkbenchState& state);

/// Properties of a picked place at the state's time, with units, for the card in the view.
///
/// @param error  of the picked marker; null: unknown
std::vector<ReportLine> lines_about(const PickedPlace& place, const WorkbenchState& state,
                                    const viewport::DrawnScene& scene, const MarkerError* error);

}  // namespace myo::ui::commands
