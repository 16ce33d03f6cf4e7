#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "calibration/calibrate.hpp"
#include "check/finding.hpp"
#include "report/json.hpp"

namespace myo::results {

/// What only the program knows about a run.
struct RunFacts {
    std::string version = {};               // of the program
    std::vector<std::string> command = {};  // as it was called
    double setup_s = 0.0;                   // reading, meshing, preparing
    std::uint64_t peak_memory_bytes = 0;
    std::optional<std::uint64_t> seed = {};     // as asked for; only starts of a search are random
    std::vector<check::Finding> findings = {};  // of the checks before and after the job
};

/// What lies in simulate.json: size, cost and comparison. Trials that did not complete are left out; `failure` says
/// why.
report::Json simulate_json(const setup::Setup& setup, const prediction::SetupRun& run, const RunFacts& facts);

/// What lies in calibrate.json: parameters with deviations and correlation, comparison before and after. What a trial
/// that did not complete would have given is null; its failure_before or failure_after says why. Asserts that the
/// calibration is usable.
report::Json calibrate_json(const setup::Setup& setup, const calibration::Calibration& calibration,
                            const RunFacts& facts);

/// Mesh, material and time integration, as every result file of a setup has them.
report::Json setup_size_json(const setup::Setup& setup);

/// rms and steady state of each marker, by its name.
report::Json marker_scores_json(const prediction::TrialScore& score);

/// How a search ended, in one word: "converged", "stopped", ...
const char* ending_word(inverse::FitStatus status);

/// The score of a trial by its name, or null.
const prediction::TrialScore* find_score(const prediction::SetupRun& run, const std::string& trial);

}  // namespace myo::results
