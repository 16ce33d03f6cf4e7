#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "calibration/calibrate.hpp"
#include "check/finding.hpp"
#include "report/json.hpp"

namespace myo::results {

/// Facts about a run that only the program knows.
struct RunFacts {
    std::string version = {};                   // of the program
    std::vector<std::string> command = {};      // command line, word by word
    double setup_s = 0.0;                       // wall-clock time of reading, meshing and preparing
    std::uint64_t peak_memory_bytes = 0;        // of the process, resident
    std::optional<std::uint64_t> seed = {};     // as requested; only starts of a search are random
    std::vector<check::Finding> findings = {};  // of the checks before and after the job
};

/// Content of simulate.json (schema simulate/1): size, cost and comparison. Trials that did not complete are left out;
/// `failure` gives the reason.
report::Json simulate_json(const setup::Setup& setup, const prediction::SetupRun& run, const RunFacts& facts);

/// Content of calibrate.json (schema calibrate/1): parameters with standard deviations and correlation, comparison
/// before and after. Values of a trial that did not complete are null; failure_before or failure_after gives the
/// reason.
///
/// Errors: none. Asserts that the calibration is usable.
report::Json calibrate_json(const setup::Setup& setup, const calibration::Calibration& calibration,
                            const RunFacts& facts);

/// Mesh, material and time integration; the same keys in every result file.
/// As a JSON object to be merged into that of the file.
report::Json setup_size_json(const setup::Setup& setup);

/// rms and steady state [m] of each marker, by name.
report::Json marker_scores_json(const prediction::TrialScore& score);

/// Column, unit, noise and rms of each sensor.
report::Json sensor_scores_json(const prediction::TrialScore& score);

/// Lines "sensor load_cell_z_N in pull: 0.012 N rms, noise 0.005 N" of all scores; empty without sensors.
///
/// @param when  "before": "sensor load_cell_z_N in pull, before: ..."; may be empty
std::string sensor_lines(const prediction::SetupRun& run, const std::string& when = "");

/// How a search ended, in one word: "converged", "stopped", ...
const char* ending_word(inverse::FitStatus status);

/// Score of a trial by name, or null if it did not complete.
/// The pointer is valid as long as the run is.
const prediction::TrialScore* find_score(const prediction::SetupRun& run, const std::string& trial);

}  // namespace myo::results
