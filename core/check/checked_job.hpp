#pragma once

#include <vector>

#include "calibration/calibrate.hpp"
#include "check/finding.hpp"

namespace myo::check {

/// What checks look at: an experiment before a job, and what the job brought after it.
struct CheckedJob {
    const setup::Setup& setup;
    const prediction::SetupRun* run = nullptr;              // with the values that the job ended with; null before it
    const calibration::Calibration* calibration = nullptr;  // where the job was one
    const std::vector<Finding>* earlier = nullptr;          // of the checks before this one in the catalogue
    bool as_declared = false;                               // the run has the declared values: nothing was fitted
    const std::vector<setup::TrialStep>* seen = nullptr;    // steps_seen_in() the run; null: they are looked for
};

}  // namespace myo::check
