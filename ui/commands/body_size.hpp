#pragma once

#include <Eigen/Core>

#include "commands/workbench_state.hpp"

namespace myo::ui::commands {

/// Extent of the open body along the axes [m]. Zero if nothing is open.
inline Eigen::Vector3d body_size(const WorkbenchState& state) {
    if (state.scene && state.scene->surface.vertices.cols() > 0)
        return mesh::bounding_box(state.scene->surface.vertices).size();
    if (state.body && state.body->mesh.node_count() > 0) return mesh::bounding_box(state.body->mesh.nodes).size();
    return Eigen::Vector3d::Zero();
}

}  // namespace myo::ui::commands
