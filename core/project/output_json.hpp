#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "project/finding.hpp"
#include "project/calibrate_study.hpp"
#include "report/json.hpp"

namespace myo {

/// What only the program knows about a run.
struct RunFacts {
    std::string version = {};                   // of the program
    std::vector<std::string> command = {};      // as it was called
    double setup_s = 0.0;                       // reading, meshing, preparing
    std::uint64_t peak_memory_bytes = 0;
    std::optional<std::uint64_t> seed = {};     // as asked for; only starts of a search are random
    std::vector<Finding> findings = {};         // of the checks before and after the job
};

/// What lies in simulate.json: size, cost and comparison. Trials that did not complete are left out; `failure` says why.
Json simulate_json(const Study& study, const StudyRun& run, const RunFacts& facts);

/// What lies in calibrate.json: parameters with deviations and correlation, comparison before and after. What a trial that did
/// not complete would have given is null; its failure_before or failure_after says why. Asserts that the calibration is usable.
Json calibrate_json(const Study& study, const Calibration& calibration, const RunFacts& facts);

/// Mesh, material and time integration, as every result file of a study has them.
Json study_size_json(const Study& study);

/// rms and steady state of each marker, by its name.
Json marker_scores_json(const TrialScore& score);

/// How a search ended, in one word: "converged", "stopped", ...
const char* ending_word(FitStatus status);

/// The score of a trial by its name, or null.
const TrialScore* find_score(const StudyRun& run, const std::string& trial);

}  // namespace myo
