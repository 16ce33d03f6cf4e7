#pragma once

#include "base/progress.hpp"
#include "base/result.hpp"
#include "project/study.hpp"

namespace myo {

/// The study with the same trials on cells of `ratio` times the edge. Errors: those of meshing.
Result<Study> refined_study(const Study& study, double ratio, const Progress& progress);

}  // namespace myo
