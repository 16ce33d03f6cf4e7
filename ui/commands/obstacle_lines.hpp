#pragma once

#include <vector>

#include "commands/scene_setup.hpp"
#include "viewport/scene.hpp"

namespace myo::ui::commands {

/// An obstacle as lines: a patch of a plane as a grid near the body, with its normal at a corner; circles of a sphere;
/// the edges of a box.
///
/// @param extent  of the body at rest [m]; the patch is as large
std::vector<viewport::DrawnLine> obstacle_lines(const SceneObstacle& obstacle, const Box& extent,
                                                const viewport::Color& color, double width);

}  // namespace myo::ui::commands
