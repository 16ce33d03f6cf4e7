#pragma once

#include <string>
#include <vector>

#include "calibration/calibrate.hpp"
#include "report/html_report.hpp"

// Sections of the page about a calibration; see calibration_report.hpp.

namespace myo::results {

/// Shown as "fit" or "predicted": a validation trial never entered the fit.
std::string role_words(experiment::TrialRole role);

report::Table parameter_table(const setup::Setup& setup, const calibration::Calibration& calibration);
/// How each start of several ended.
report::Table starts_table(const setup::Setup& setup, const calibration::Calibration& calibration);
report::Table trial_table(const setup::Setup& setup, const calibration::Calibration& calibration);

/// One section per trial: figure of the worst marker, steady state, the other markers folded away; where the trial did
/// not complete before or after the fit, why.
report::Section trial_section(const setup::Setup& setup, const calibration::Calibration& calibration,
                              std::size_t trial);

/// Mesh, material, time integration, and the noise.
report::Section model_section(const setup::Setup& setup, const calibration::Calibration& calibration);

}  // namespace myo::results
