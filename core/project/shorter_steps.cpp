#include "project/shorter_steps.hpp"

#include <algorithm>
#include <utility>

#include "project/time_step.hpp"

namespace myo {

bool much_shorter(const Study& study, const std::vector<TrialStep>& steps) {
    for (std::size_t t = 0; t < steps.size(); ++t)
        if (steps[t].h_s < shorter_steps_policy.least_change * study.trials[t].options.h_s) return true;
    return false;
}

void set_shorter_steps(Study& study, std::vector<TrialStep> steps) {
    for (std::size_t t = 0; t < steps.size(); ++t) steps[t].h_s = std::min(steps[t].h_s, study.trials[t].options.h_s);
    set_steps(study, std::move(steps));
}

}  // namespace myo
