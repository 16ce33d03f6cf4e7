#pragma once

#include "fibre/signal.hpp"

namespace myo::fibre {

/// Criteria for a switch: a rise or fall too short to be resolved by time steps of length h.
struct SwitchRule {
    /// The flanks next to the steepest interval belong to the switch as long as their slope is at least this fraction
    /// of its slope.
    double flank_slope = 0.1;
    /// Other changes within a step before and after the switch may sum up to this fraction of it. In a noisy recording
    /// a change has similar noise next to it; treating its samples as switches would reduce the step to the sampling
    /// interval.
    double quiet_share = 0.5;
    /// Adjacent switches may differ in size by this factor, and there may be at most max_adjacent of them.
    double size_ratio = 2.0;
    int max_adjacent = 4;
    /// Jump times are rounded to this fraction of a step: very short steps would amplify the rounding of positions in
    /// the accelerations. Shifts a switch by at most 5e-4 h.
    double time_grid = 1e-3;
};

/// Replaces every switch shorter than a time step by a jump.
///
/// An integrator samples a signal at its stages. It sees a rise within a step as one that starts or ends with the step:
/// a shift of up to h / 2, hence a first-order error. A jump ends a step and preserves second order. The jump is placed
/// so that the integral of the signal is preserved; the rest of the signal and existing jumps are unchanged.
///
/// @param h_s  time step of the run [s]
Signal with_switches_as_jumps(const Signal& signal, double h_s, const SwitchRule& rule = {});

}  // namespace myo::fibre
