#pragma once

#include <vector>

#include "base/progress.hpp"
#include "check/finding.hpp"
#include "setup/setup.hpp"

namespace myo::check {

/// What is found of the units, in which an experiment and its recordings are written.
std::vector<Finding> findings_on_units(const setup::Setup& setup);

/// Sets the steps that suit the declared values. Where a unit is in doubt, these tell no step: a body that is declared
/// a thousand times too light would be run with thousands of steps per sample. Half a sampling interval then stays, as
/// if it had been asked for.
void choose_declared_steps(setup::Setup& setup, const std::vector<Finding>& on_units, const Progress& progress = {});

}  // namespace myo::check
