#pragma once

#include <string>

namespace myo::setup {

/// The time step of one trial and what it is good for.
struct TrialStep {
    double h_s = 0.0;
    double vibration_Hz = 0.0;        // of the natural vibration that moves the markers most; 0: none is seen
    double vibration_m = 0.0;         // its amplitude at the markers, rms over them and the trial
    double frequency_error = 0.0;     // of the step in that vibration, relative; 0 where none is seen
    double other_vibrations_m = 0.0;  // of the step, in the traces of the others, rms over markers and the trial
    double trace_error_m = 0.0;       // of the step, rms over compared coordinates, where no vibration is seen
    bool settled = true;              // false: the runs that the policy grants did not suffice
    std::string failure;              // why the trial could not be run, which leaves half a sampling interval
};

}  // namespace myo::setup
