#pragma once

#include <Eigen/Core>

#include "commands/backend.hpp"

namespace myo::ui::commands {

/// Edges of the elements on the surface of the body at rest, each once: pairs of points, divided by columns that are
/// not finite, 3 x n [m].
Eigen::Matrix3Xd rest_outline(const MeshedBody& body);

}  // namespace myo::ui::commands
