#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "experiment/experiment.hpp"

namespace myo::experiment {

/// Gives some trials with role `fit` the role `validate`, drawn at random, so that a model is judged by trials that it
/// was not fitted to. The draw depends on count, seed and the order of the trials only.
///
/// @param count  number of trials, not negative
/// @return       their names, in the order of the experiment
/// Errors: fewer than one trial would be left to fit.
Result<std::vector<std::string>> leave_out(Experiment& experiment, int count, std::uint64_t seed);

}  // namespace myo::experiment
