#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/result.hpp"
#include "calibration/optimize.hpp"
#include "report/html_report.hpp"
#include "results/output_json.hpp"

namespace myo::results {

/// State of an earlier search, read from its optimize.json.
/// Values are those of the best run, at which a resumed search begins.
struct EarlierOptimization {
    Eigen::MatrixXd values;               // signals x knots
    Eigen::VectorXd design = {};          // values of the design; empty: none is sought
    int evaluations = 0;                  // in all
    std::vector<std::string> notes = {};  // what was written by an earlier version and read differently
};
/// Reads the state of an earlier search from optimize.json.
///
/// @param folder  output folder of the earlier call
/// Errors: the file is missing or has another form; another trial, other signals, knots or quantities of the body.
Result<EarlierOptimization> read_optimization(const std::filesystem::path& folder, const setup::Setup& setup,
                                              const inverse::ActuationProblem& problem);

/// Content of optimize.json (schema optimize/1).
/// Read back by read_optimization(): keys and meanings must stay.
///
/// Errors: none. Asserts that the optimization is usable, as do the functions below.
report::Json optimize_json(const setup::Setup& setup, const calibration::Optimization& optimization,
                           const RunFacts& facts);

/// Name of the file of the signals found for the trial of a setup, `<trial>_actuation.csv`.
std::filesystem::path actuation_file_name(const setup::Setup& setup);

/// Writes `<trial>_actuation.csv` in the schema's format, one column per muscle that follows none, chamber and tendon,
/// and `<trial>.csv` with the simulated markers. A held signal has two rows per knot, so `simulate` reproduces the run.
/// Without sought signals only the markers are written.
///
/// Errors: a file cannot be written.
Result<void> write_actuation(const std::filesystem::path& folder, const setup::Setup& setup,
                             const calibration::Optimization& optimization);

/// All files `<trial>_actuation.csv` that write_actuation() may write, over all trials of the experiment.
std::vector<std::filesystem::path> actuation_files(const std::filesystem::path& folder,
                                                   const experiment::Experiment& experiment);

/// HTML report of a search: signals, markers and targets, history of the loss. optimize.json is embedded.
report::HtmlReport optimize_report(const setup::Setup& setup, const calibration::Optimization& optimization,
                                   const RunFacts& facts);

}  // namespace myo::results
