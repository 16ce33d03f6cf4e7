#pragma once

#include "commands/workbench_state.hpp"
#include "viewport/scene.hpp"

namespace myo::ui::commands {

/// Colour of a chamber or tendon, one of the theme's colours of muscles.
///
/// @param actuator  index in BodyActuators: chambers first, then tendons. Colours continue behind those of the muscles.
viewport::Color actuator_color(const WorkbenchState& state, const platform::Theme& theme, std::size_t actuator);

/// Tints the walls of all chambers, outlines them, and draws all tendons along their guides. Does nothing without a
/// meshed body, or if the view hides actuators.
void add_actuators(viewport::DrawnScene& drawn, const WorkbenchState& state, const platform::Theme& theme);

}  // namespace myo::ui::commands
