#pragma once

#include <vector>

#include "base/progress.hpp"
#include "check/finding.hpp"
#include "setup/setup.hpp"

namespace myo::check {

/// Findings of the checks of units and of the time unit, which need no time step.
std::vector<Finding> findings_on_units(const setup::Setup& setup);

/// Refuses trials whose times are certainly in another unit than seconds, unless the key `time_unit` is set: a run of
/// them would take thousands of times as long and explain nothing.
///
/// @param findings  with those of the check `time_unit`
/// Errors: key and line of the trial; the message names the likely unit.
Result<void> require_time_unit(const setup::Setup& setup, const std::vector<Finding>& findings);

/// Chooses time steps for the declared values and sets them in the setup.
///
/// If a unit is doubtful, half a sampling interval is fixed instead, as if it had been requested: a body declared a
/// thousand times too light would be simulated with thousands of steps per sample.
///
/// @param on_units  result of findings_on_units()
void choose_declared_steps(setup::Setup& setup, const std::vector<Finding>& on_units, const Progress& progress = {});

}  // namespace myo::check
