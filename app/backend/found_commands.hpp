#pragma once

#include <vector>

#include "commands/declaration.hpp"
#include "experiment/experiment.hpp"
#include "fibre/signal.hpp"

namespace myo::backend {

/// Edits that declare the commands which a search found for the chambers and tendons of a trial, as curves over time,
/// or as constants of a hold.
///
/// @param trial     index in the experiment
/// @param commands  per chamber, then per tendon, in the order of declaration [Pa, N or m]; empty: not sought
/// @return  empty if there are none, or if the trial's actuation file holds commands of one
std::vector<ui::commands::DeclarationEdit> found_command_edits(
    const experiment::Experiment& experiment, std::size_t trial,
    const std::vector<std::optional<fibre::Signal>>& commands);

}  // namespace myo::backend
