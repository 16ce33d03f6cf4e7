#pragma once

#include "base/result.hpp"
#include "sensitivity/run_tape.hpp"

namespace myo::sensitivity {

/// Checkpointing plan of a run for its backward pass: parts, of which one at a time is on a tape.
struct RunParts {
    int parts = 1;
    int steps_per_part = 1;
    int points_every = 1;  // whole states on the tape, one per this many steps
    double bytes = 0.0;    // largest memory of the tape
};

/// Plan with the fewest parts whose memory is within the budget.
///
/// Errors: the budget is below the minimum; the message states the minimum.
Result<RunParts> plan_parts(int steps, const TapeBytes& cost, double budget_bytes);

}  // namespace myo::sensitivity
