#pragma once

#include <vector>

#include "calibration/calibrate.hpp"
#include "check/finding.hpp"

namespace myo::check {

/// Input of the checks: the experiment before a job, and the result after it. Pointers are owned by the caller and must
/// outlive the checks, as must the setup.
struct CheckedJob {
    const setup::Setup& setup;
    const prediction::SetupRun* run = nullptr;              // with the final values of the job; null before it
    const calibration::Calibration* calibration = nullptr;  // null unless the job was a calibration
    const std::vector<Finding>* earlier = nullptr;          // findings of the checks before this one in the catalogue
    bool as_declared = false;                               // the run has the declared values: nothing was fitted
    const std::vector<setup::TrialStep>* seen = nullptr;    // steps_seen_in() the run; null: computed by the check
};

}  // namespace myo::check
