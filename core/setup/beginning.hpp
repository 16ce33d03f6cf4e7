#pragma once

#include "setup/setup.hpp"

namespace myo::setup {

/// Shortens a trial to the first samples of its recording; its run then ends one sampling interval after the last of
/// them. Unchanged if the recording has no more samples. Weights of goals are not shortened.
///
/// @param samples  number to keep, counted from the first recorded sample, those before t = 0 included; at least 1
void keep_beginning(PreparedTrial& trial, Eigen::Index samples);

}  // namespace myo::setup
