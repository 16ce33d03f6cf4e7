#pragma once

#include <vector>

#include "setup/setup.hpp"

namespace myo::prediction {

/// When a fit goes on with shorter steps, because its values ask for them.
struct ShorterStepsPolicy {
    double least_change = 0.85;  // a step shortened by less changes the error by a quarter at most
    int most_fits = 3;           // declared values a factor of a hundred off come to rest after two
};
inline constexpr ShorterStepsPolicy shorter_steps_policy;

/// Whether a trial's step is shortened enough by these to matter.
bool much_shorter(const setup::Setup& setup, const std::vector<setup::TrialStep>& steps);

/// Sets them in the setup, none longer than it has now.
void set_shorter_steps(setup::Setup& setup, std::vector<setup::TrialStep> steps);

}  // namespace myo::prediction
