#pragma once

#include "project/run_study.hpp"

namespace myo {

/// One trial, as far as `end_s`: step for step as in a whole run. Samples after that are NaN, the other trials have status not_run.
StudyRun short_run(const Study& study, const StudyValues& values, std::size_t trial, double end_s, const Progress& progress = {});

}  // namespace myo
