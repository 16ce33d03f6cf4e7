#pragma once

#include <vector>

#include "prediction/run_trials.hpp"
#include "report/html_report.hpp"
#include "report/json.hpp"

// What a robot has beyond one material, in reports: chambers, tendons, parts, obstacles, and what sensors read.

namespace myo::results {

/// Tables of the chambers, tendons, parts and obstacles that are declared; empty for a body without them.
/// In readable units.
///
/// @param values  of the materials of the parts
std::vector<report::Block> robot_tables(const setup::Setup& setup, const prediction::ParameterValues& values);

/// Rms of every column of the sensors in every trial, before and after a fit; null `after`: only one run. Without rows
/// if there are no sensors.
report::Table sensor_table(const setup::Setup& setup, const prediction::SetupRun& before,
                           const prediction::SetupRun* after);

/// Chambers (volume, wall area at rest), tendons (drive, length at rest, guides) and the ranges of their commands over
/// the trials; empty object for a body without them.
report::Json robot_json(const setup::Setup& setup);

}  // namespace myo::results
