#pragma once

#include "mesh/surface_mesh.hpp"
#include "viewport/scene.hpp"

namespace myo::ui::commands {

/// Draws a box at rest and tints the faces of the drawn body that lie in it. Requires that the body is drawn at rest.
void add_region(viewport::DrawnScene& drawn, const Box& box_m, const viewport::Color& color);

}  // namespace myo::ui::commands
