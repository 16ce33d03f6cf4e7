#pragma once

#include <string>
#include <vector>

#include "project/calibrate_study.hpp"
#include "report/html_report.hpp"

// Sections of the page about a calibration; see study_report.hpp.

namespace myo {

/// Shown as "fit" or "predicted": a validation trial never entered the fit.
std::string role_words(TrialRole role);

Table parameter_table(const Study& study, const Calibration& calibration);
/// How each start of several ended.
Table starts_table(const Study& study, const Calibration& calibration);
Table trial_table(const Study& study, const Calibration& calibration);

/// One section per trial: figure of the worst marker, steady state, the other markers folded away; where the trial did not
/// complete before or after the fit, why.
Section trial_section(const Study& study, const Calibration& calibration, std::size_t trial);

/// Mesh, material, time integration, and the noise.
Section model_section(const Study& study, const Calibration& calibration);

}  // namespace myo
