#pragma once

#include "base/progress.hpp"
#include "base/result.hpp"
#include "setup/setup.hpp"

namespace myo::setup {

/// A setup prepared again on cells of `ratio` times the edge length (ratio < 1 refines), with the same element.
/// Recordings are read again, so that a changed file changes the result. Errors: those of prepare_setup().
Result<Setup> refined_setup(const Setup& setup, double ratio, const Progress& progress);

}  // namespace myo::setup
