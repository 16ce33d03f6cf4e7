#include "prediction/shorter_steps.hpp"

#include <algorithm>
#include <utility>

#include "prediction/time_step.hpp"

namespace myo::prediction {

bool much_shorter(const setup::Setup& setup, const std::vector<setup::TrialStep>& steps) {
    for (std::size_t t = 0; t < steps.size(); ++t)
        if (steps[t].h_s < shorter_steps_policy.min_change * setup.trials[t].options.h_s) return true;
    return false;
}

void set_shorter_steps(setup::Setup& setup, std::vector<setup::TrialStep> steps) {
    for (std::size_t t = 0; t < steps.size(); ++t) steps[t].h_s = std::min(steps[t].h_s, setup.trials[t].options.h_s);
    set_steps(setup, std::move(steps));
}

}  // namespace myo::prediction
