#pragma once

#include "base/result.hpp"
#include "sensitivity/run_tape.hpp"

namespace myo::sensitivity {

/// How a run is kept for its transposition: cut into parts, of which one at a time is on a tape.
struct RunParts {
    int parts = 1;
    int steps_per_part = 1;
    int points_every = 1;  // whole states on the tape
    double bytes = 0.0;    // at most
};

/// The fewest parts that fit into the budget. Errors: no number does.
Result<RunParts> plan_parts(int steps, const TapeBytes& cost, double budget_bytes);

}  // namespace myo::sensitivity
