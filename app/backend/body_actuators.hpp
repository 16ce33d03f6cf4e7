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
/// @param surface   declared surface of the body, closed [m]
/// @param mesh      mesh of that body
/// @param boundary  faces of `mesh`, to which the chambers' walls are numbered
/// @return          volumes [m3], areas [m2] and places [m] at rest; guides that stand still have no nodes
/// Errors: those of setup::find_chambers(), for example a cavity that a coarse mesh lost.
Result<ui::commands::BodyActuators> body_actuators(const experiment::Experiment& experiment,
                                                   const mesh::SurfaceMesh& surface, const setup::BodyMesh& mesh,
                                                   const mesh::BoundaryFaces& boundary);

/// Pressures, tensions and shortenings of a trial by the actuators' names, in SI with the unit to show them in.
///
/// Unknown levels are zero. Muscles are left out: their activations are shown apart.
std::map<std::string, ui::commands::ShownCommand> shown_commands(const setup::Setup& setup,
                                                                 const setup::PreparedTrial& trial);

/// Unit in which the command of an actuator is shown (kPa, mm, otherwise its SI unit) with its size in SI; the signal
/// is empty.
ui::commands::ShownCommand shown_unit(const experiment::Actuator& actuator);

}  // namespace myo::backend
