#pragma once

#include "commands/scene_at_time.hpp"
#include "mesh/face_table.hpp"

namespace myo::ui::commands {

/// The body as the view's plane cuts it. Keeps the faces of the body, so that moving the plane takes one pass over
/// them.
class BodyCut {
public:
    /// Puts what is left of the body into the summary of its motion; does nothing when it is there already.
    void apply(const WorkbenchState& state, MotionSummary& motion);

private:
    std::shared_ptr<const MeshedBody> body_;  // of the table
    mesh::FaceTable table_;
    ClipPlane plane_;                                 // of the last cut
    std::shared_ptr<const viewport::DrawnBody> cut_;  // by it
};

/// Closed line in which a plane cuts a box; empty where it misses it.
Eigen::Matrix3Xd outline_of(const ClipPlane& plane, const Box& box);

}  // namespace myo::ui::commands
