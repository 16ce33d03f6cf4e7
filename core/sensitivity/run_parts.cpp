#include "sensitivity/run_parts.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"

namespace myo::sensitivity {

Result<RunParts> plan_parts(int steps, const TapeBytes& cost, double budget_bytes) {
    // Try an increasing number of parts: fewer parts mean fewer steps that run twice.
    double least = 0.0;
    for (int parts = 1; parts <= std::max(steps, 1); ++parts) {
        RunParts plan;
        plan.steps_per_part = std::max(1, (steps + parts - 1) / parts);
        plan.parts = std::max(1, (steps + plan.steps_per_part - 1) / plan.steps_per_part);
        // Memory of a part with n steps is n / m whole states plus m step records, for blocks of m steps: m = sqrt(n)
        // balances the two.
        plan.points_every = std::max(1, static_cast<int>(std::lround(std::sqrt(plan.steps_per_part))));
        const int points = plan.steps_per_part / plan.points_every + 1;
        const double cuts = plan.parts > 1 ? plan.parts : 0;
        plan.bytes = plan.steps_per_part * cost.per_step + (points + cuts) * cost.per_state +
                     plan.points_every * cost.per_record;
        if (plan.bytes <= budget_bytes) return plan;
        least = parts == 1 ? plan.bytes : std::min(least, plan.bytes);
    }
    return Error{"the gradient of " + std::to_string(steps) + (steps == 1 ? " step" : " steps") + " needs at least " +
                     format_number(least / 1e6, 3) + " MB, more than its budget of " +
                     format_number(budget_bytes / 1e6, 3) + " MB",
                 {}};
}

}  // namespace myo::sensitivity
