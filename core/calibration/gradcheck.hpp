#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sensitivity/gradient_check.hpp"
#include "setup/setup.hpp"

namespace myo::calibration {

/// Gradient check of one trial: the adjoint gradient of a marker loss against finite differences.
struct TrialGradientCheck {
    sensitivity::GradientCheck check;
    std::vector<std::string> left_out;  // numbers of effects and parts without a row, with the reason
    double loss_m2 = 0.0;               // mean square distance of the markers to their targets
    bool against_trace = false;         // targets are the measured positions, else the rest positions
    int steps = 0;
    double end_s = 0.0;    // simulated time
    double seconds = 0.0;  // wall-clock time
};

/// Compares the gradient over the first `steps` time steps with differences, for every input of the trial's model,
/// and the tangents of fits by numbers of effects and parts, see declared_gradients().
///
/// So that every input influences the loss, the run starts with a smooth velocity field of up to half the body size per
/// second, free levels are half a scale from passive (1.05 of a muscle), tendons are never slack, and camera frame and
/// clock are slightly off.
///
/// @param trial  index into Setup::trials
/// @param steps  number of time steps, > 0; the differences take several runs per input
/// Errors: those of the runs, in the status of the check.
TrialGradientCheck gradcheck(const setup::Setup& setup, std::size_t trial, int steps, const Progress& progress = {});

}  // namespace myo::calibration
