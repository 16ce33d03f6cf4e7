#pragma once

#include <Eigen/Core>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "commands/marker_errors.hpp"
#include "commands/workbench_state.hpp"
#include "viewport/camera.hpp"
#include "viewport/scene.hpp"

namespace myo::ui::commands {

/// A marker, or a place on the body that moves with it.
struct PickedPlace {
    int marker = -1;                                    // of the scene; -1: on the body
    bool simulated = false;                             // the marker
    std::array<int, 3> corners{-1, -1, -1};             // nodes between which the place lies
    Eigen::Vector3d weights = Eigen::Vector3d::Zero();  // of them, sum 1
    int node = -1;                                      // nearest of the picked face
    int cell = -1;                                      // behind it
};

/// What lies under a pixel of the view: a marker at most `reach` pixels away that the body does not hide, else the
/// body.
std::optional<PickedPlace> pick_place(const WorkbenchState& state, const viewport::DrawnScene& scene,
                                      const viewport::Camera& camera, const viewport::ViewSize& size,
                                      const Eigen::Vector2d& pixel, double reach);

/// The place at most `reach` pixels away from a pixel and nearest to it, of those that the body hides only where it
/// hides all; empty without one.
std::optional<std::size_t> pick_one(const std::vector<Eigen::Vector3d>& places_m, const viewport::DrawnScene& scene,
                                    const viewport::Camera& camera, const viewport::ViewSize& size,
                                    const Eigen::Vector2d& pixel, double reach);

/// Where it is drawn now [m]; NaN for a marker that is not.
Eigen::Vector3d place_now(const PickedPlace& place, const viewport::DrawnScene& scene);
/// Where it is at rest [m]. The state's body is the one that was picked.
Eigen::Vector3d place_at_rest(const PickedPlace& place, const WorkbenchState& state);

/// What there is to say of it at the state's time, with units.
///
/// @param error  of a marker; null: none is known
std::vector<ReportLine> lines_about(const PickedPlace& place, const WorkbenchState& state,
                                    const viewport::DrawnScene& scene, const MarkerError* error);

}  // namespace myo::ui::commands
