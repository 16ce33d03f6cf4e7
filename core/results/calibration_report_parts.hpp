#pragma once

#include <string>
#include <vector>

#include "calibration/calibrate.hpp"
#include "report/html_report.hpp"

// Sections of the HTML report of a calibration; see calibration_report.hpp.

namespace myo::results {

/// Fitted values with total standard deviation and its parts by noise, mesh and step.
/// Numbers are in readable units (kPa, ms, mm); a dash stands for an unknown deviation.
report::Table parameter_table(const setup::Setup& setup, const calibration::Calibration& calibration);
/// Outcome of each start of a multi-start fit.
/// A start that could not be run has dashes.
report::Table starts_table(const setup::Setup& setup, const calibration::Calibration& calibration);
/// rms of each trial before and after the fit, and the worst steady-state error.
/// In mm; a dash for a trial that did not complete.
report::Table trial_table(const setup::Setup& setup, const calibration::Calibration& calibration);

/// Section of one trial: chart of the worst marker, steady state, charts of the other markers collapsed; the reason if
/// the trial did not complete before or after the fit.
report::Section trial_section(const setup::Setup& setup, const calibration::Calibration& calibration,
                              std::size_t trial);

/// Mesh, material, time integration, and noise of the markers.
report::Section model_section(const setup::Setup& setup, const calibration::Calibration& calibration);

}  // namespace myo::results
