#pragma once

#include "base/result.hpp"
#include "experiment/experiment.hpp"

namespace myo::setup {

/// Refuses declarations that are read but have no physics yet, so that none is ignored silently.
///
/// Errors: "<key>: ... cannot be simulated yet" at the line of the first of them.
Result<void> refuse_unsupported(const experiment::Experiment& experiment);

}  // namespace myo::setup
