#pragma once

#include <string>

namespace myo::setup {

/// Time step of one trial with its estimated errors.
struct TrialStep {
    double h_s = 0.0;           // time step [s]
    double vibration_Hz = 0.0;  // natural frequency of the vibration with the largest marker motion; 0: none detected
    double vibration_m = 0.0;   // its amplitude, rms over markers and time
    double frequency_error = 0.0;     // relative error of the step in this frequency; 0 if none is detected
    double other_vibrations_m = 0.0;  // error of the step in the traces of the other vibrations, rms
    double trace_error_m = 0.0;       // error of the step, rms over compared coordinates, if no vibration is detected
    bool settled = true;              // false: not converged within the allowed number of runs
    std::string failure;              // why the trial could not run; then h_s is half a sampling interval
};

}  // namespace myo::setup
