#pragma once

#include "setup/setup.hpp"

namespace myo::setup {

/// Keeps the first samples of a trial's recording, and of its run what they need. Unchanged if it has no more.
void keep_beginning(PreparedTrial& trial, Eigen::Index samples);

}  // namespace myo::setup
