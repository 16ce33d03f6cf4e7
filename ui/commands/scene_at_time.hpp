#pragma once

#include <Eigen/Core>

#include <vector>

#include "commands/field_store.hpp"
#include "commands/workbench_state.hpp"
#include "viewport/scene.hpp"

namespace myo::ui::commands {

/// Two neighbouring samples and the weight of the later one; index -1 when there are none. Outside the range: its end.
struct TimePlace {
    Eigen::Index index = -1;
    Eigen::Index next = -1;
    double weight = 0.0;
};
TimePlace place_in_time(const Eigen::VectorXd& time_s, double t);

/// Linear between samples; NaN when either is. Asserts a place.
Eigen::Vector3d at_time(const Eigen::Matrix3Xd& track, const TimePlace& place);

/// Node positions at the current time; the rest shape without a run.
Eigen::Matrix3Xd positions_at_time(const WorkbenchState& state);

/// What of a picture does not change with time.
struct MotionSummary {
    Box rest;   // of body and markers at rest
    Box reach;  // of all that the trial's motion covers
    std::shared_ptr<const viewport::DrawnSurface>
        surface;  // triangles of the body or, before it is meshed, of the surface; may be null
    std::shared_ptr<const viewport::DrawnBody> body;  // null: not meshed
};
MotionSummary summarize_motion(const WorkbenchState& state);

/// The 3D picture of the state's trial at its time.
///
/// @param motion  of the same scene, body, run and trial
/// @param live    paint of the chosen muscle while a stroke goes on; may be null
/// @param field   values that colour the body, of this kind; may be null
viewport::DrawnScene scene_at_time(const WorkbenchState& state, const platform::Theme& theme,
                                   const MotionSummary& motion, const fibre::CellPaint* live = nullptr,
                                   const FieldKind* kind = nullptr, const FieldFrame* field = nullptr);

/// Places in the history of the ended jobs whose simulated markers are drawn as rings, in the colours that their curves
/// have in the plots. The shown run is left out.
std::vector<std::size_t> compared_records(const WorkbenchState& state);

}  // namespace myo::ui::commands
