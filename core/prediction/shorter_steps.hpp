#pragma once

#include <vector>

#include "setup/setup.hpp"

namespace myo::prediction {

/// When a fit is repeated with shorter time steps because the fitted values require them.
struct ShorterStepsPolicy {
    double min_change = 0.85;  // a step shortened by less changes the error by a quarter at most
    int max_fits = 3;          // declared values off by a factor of a hundred need two
};
inline constexpr ShorterStepsPolicy shorter_steps_policy;

/// Whether these steps shorten that of some trial enough to repeat the fit.
bool much_shorter(const setup::Setup& setup, const std::vector<setup::TrialStep>& steps);

/// Sets these steps in the setup; none becomes longer than it is.
void set_shorter_steps(setup::Setup& setup, std::vector<setup::TrialStep> steps);

}  // namespace myo::prediction
