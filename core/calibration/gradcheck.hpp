#pragma once

#include <cstddef>

#include "sensitivity/gradient_check.hpp"
#include "setup/setup.hpp"

namespace myo::calibration {

/// The gradient check of a trial: its model, the first steps of its run, and the loss.
struct TrialGradientCheck {
    sensitivity::GradientCheck check;
    double loss_m2 = 0.0;        // mean square distance of the markers to their targets
    bool against_trace = false;  // the targets are the measured positions; else those at rest
    int steps = 0;
    double end_s = 0.0;
    double seconds = 0.0;
};

/// Compares the gradient of the first `steps` steps with differences, for all that the trial's model depends on.
///
/// So that everything matters to the loss, the run begins with a kick, a smooth field of velocities of up to half the
/// body's size per second, free levels of actuation are 1.05, and the cameras' frame and clock are a little off.
/// Errors: those of the runs, in the check's status.
TrialGradientCheck gradcheck(const setup::Setup& setup, std::size_t trial, int steps, const Progress& progress = {});

}  // namespace myo::calibration
