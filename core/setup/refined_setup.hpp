#pragma once

#include "base/progress.hpp"
#include "base/result.hpp"
#include "setup/setup.hpp"

namespace myo::setup {

/// The same trials on cells of `ratio` times the edge length (ratio < 1 refines). Errors: those of prepare_setup().
Result<Setup> refined_setup(const Setup& setup, double ratio, const Progress& progress);

}  // namespace myo::setup
