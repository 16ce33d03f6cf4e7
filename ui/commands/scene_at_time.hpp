#pragma once

#include <Eigen/Core>

#include <vector>

#include "commands/field_store.hpp"
#include "commands/workbench_state.hpp"
#include "viewport/scene.hpp"

namespace myo::ui::commands {

/// Position of a time between two samples: their indices and the weight of the later one. Before the first or after the
/// last sample it is that sample. index is -1 if there are no samples.
struct TimePlace {
    Eigen::Index index = -1;  // of the sample at or before the time
    Eigen::Index next = -1;   // of the one after; at the last sample that itself
    double weight = 0.0;      // 0 to 1
};
/// Finds the samples around time `t` [s].
///
/// @param time_s  ascending; may be empty
TimePlace place_in_time(const Eigen::VectorXd& time_s, double t);

/// Interpolates a track linearly. NaN if a required sample is a gap. Asserts that the place exists.
Eigen::Vector3d at_time(const Eigen::Matrix3Xd& track, const TimePlace& place);

/// Node positions at the shown time, 3 x n [m]. The rest shape if there is no run; the surface if there is no mesh.
Eigen::Matrix3Xd positions_at_time(const WorkbenchState& state);

/// The part of a picture that does not change with time. Computed when scene, body, run or trial change, not in each
/// frame.
struct MotionSummary {
    Box rest;   // of body and markers at rest [m]
    Box reach;  // of the whole motion of the trial [m]
    // Triangles of the body; before it is meshed, of the surface. May be null.
    std::shared_ptr<const viewport::DrawnSurface> surface;
    std::shared_ptr<const viewport::DrawnBody> body;  // null: not meshed
    std::shared_ptr<const Eigen::Matrix3Xd>
        outline;                           // of the meshed body at rest, see rest_outline(); null: not meshed
    std::vector<std::vector<int>> loaded;  // per load of the trial: indices of the points that positions_at_time() has
    std::vector<int> part_of_cell;         // of the scene's parts, -1: none; empty without parts or a body
};
/// Computes the summary for the shown trial.
MotionSummary summarize_motion(const WorkbenchState& state);

/// The state with body and markers at rest: no trial and no run are shown.
WorkbenchState at_rest(WorkbenchState state);

/// The field that colours the body, in the unit of its legend. The range of the colours is the one fixed by the user;
/// otherwise that of the trial, so that colours can be compared over time; until it is known, that of the frame.
///
/// @param nodes  of the body
/// @return       empty if the values belong to another body
std::optional<viewport::DrawnField> drawn_field(const ViewOptions& view, const FieldKind& kind, const FieldFrame& frame,
                                                Eigen::Index nodes);

/// Creates the 3D picture of the shown trial at the shown time. Empty if nothing is open.
///
/// @param motion  summary of the same scene, body, run and trial
/// @param live  paint of the selected muscle, or of the part that the brush paints, during a stroke; may be null
/// @param kind, field  field that colours the body and its values; may be null
viewport::DrawnScene scene_at_time(const WorkbenchState& state, const platform::Theme& theme,
                                   const MotionSummary& motion, const fibre::CellPaint* live = nullptr,
                                   const FieldKind* kind = nullptr, const FieldFrame* field = nullptr);

/// Indices in the history of the ended jobs that are compared and have a run. Their markers are drawn as rings, in the
/// colours of their curves in the plots. The shown run is left out.
std::vector<std::size_t> compared_records(const WorkbenchState& state);

}  // namespace myo::ui::commands
