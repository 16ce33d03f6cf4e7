#pragma once

#include "fibre/signal.hpp"

namespace myo::fibre {

/// What counts as switching: a rise or fall whose sampled course a run with steps of h cannot see.
struct SwitchRule {
    /// Beside the steepest interval of a switch its flanks count as part of it down to this share of its slope.
    double flank_slope = 0.1;
    /// Changes within a step before and after it that are no switches of about its size may add up to this share of it.
    /// Beside a change of a noisy log there is as much noise; to take its samples for switches would cut the run to its
    /// rate.
    double quiet_share = 0.5;
    /// So many times larger or smaller another switch beside it may be, and so many of them there may be.
    double alike = 2.0;
    int most_beside = 4;
    /// Times of jumps are multiples of this part of a step: steps much shorter would turn the rounding of positions
    /// into accelerations. It shifts a switch by 5e-4 h at most.
    double time_grid = 1e-3;
};

/// The signal with every switch within less than a time step made a jump.
///
/// An integrator takes a signal at its stages. A rise within a step it sees as one that begins or ends with the step,
/// which shifts it by up to h / 2 and makes an error of first order. A jump ends a step, and the run keeps its second
/// order. The jump stands where the signal keeps its integral; what lies between jumps stays as it is. Jumps that the
/// signal has already stay, too.
///
/// @param h_s  step of the run [s]
Signal with_switches_as_jumps(const Signal& signal, double h_s, const SwitchRule& rule = {});

}  // namespace myo::fibre
