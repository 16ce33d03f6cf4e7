#pragma once

#include <map>
#include <string>

#include "commands/backend.hpp"
#include "commands/body_actuators.hpp"
#include "experiment/actuators.hpp"
#include "setup/setup.hpp"

namespace myo::backend {

/// Chambers and tendons of an experiment on a mesh of its body, for drawing.
///
/// Errors: those of setup::find_chambers().
Result<ui::commands::BodyActuators> body_actuators(const experiment::Experiment& experiment,
                                                   const mesh::SurfaceMesh& surface, const setup::BodyMesh& mesh,
                                                   const mesh::BoundaryFaces& boundary);

/// Pressures, tensions and shortenings of a trial by the actuators' names; unknown levels are zero.
std::map<std::string, ui::commands::ShownCommand> shown_commands(const setup::Setup& setup,
                                                                 const setup::PreparedTrial& trial);

/// Unit in which the command of an actuator is shown; without a signal.
ui::commands::ShownCommand shown_unit(const experiment::Actuator& actuator);

}  // namespace myo::backend
