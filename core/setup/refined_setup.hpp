#pragma once

#include "base/progress.hpp"
#include "base/result.hpp"
#include "setup/setup.hpp"

namespace myo::setup {

/// The setup with the same trials on cells of `ratio` times the edge. Errors: those of meshing.
Result<Setup> refined_setup(const Setup& setup, double ratio, const Progress& progress);

}  // namespace myo::setup
