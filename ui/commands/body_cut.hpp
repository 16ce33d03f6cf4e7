#pragma once

#include "commands/scene_at_time.hpp"
#include "mesh/face_table.hpp"

namespace myo::ui::commands {

/// Cuts the drawn body by the view's clip plane. Keeps the table of the body's faces, so that moving the plane costs
/// one pass over the faces.
class BodyCut {
public:
    /// Replaces body and surface in `motion` by the part that the plane leaves. Does nothing if `motion` already shows
    /// this cut, or if no body is meshed.
    void apply(const WorkbenchState& state, MotionSummary& motion);

private:
    std::shared_ptr<const MeshedBody> body_;          // body of table_
    mesh::FaceTable table_;                           // faces of all cells of body_
    ClipPlane plane_;                                 // of the last cut
    std::shared_ptr<const viewport::DrawnBody> cut_;  // result of the last cut
};

/// Closed polygon in which a plane cuts a box [m], 3 x n with the first point repeated at the end. No columns if the
/// plane misses the box.
Eigen::Matrix3Xd outline_of(const ClipPlane& plane, const Box& box);

}  // namespace myo::ui::commands
