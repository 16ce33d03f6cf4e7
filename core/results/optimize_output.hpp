#pragma once

#include <filesystem>
#include <vector>

#include <Eigen/Core>

#include "base/result.hpp"
#include "calibration/optimize.hpp"
#include "report/html_report.hpp"
#include "results/output_json.hpp"

namespace myo::results {

/// Where an earlier call has left off: the values in its optimize.json.
struct EarlierOptimization {
    Eigen::MatrixXd values;  // signals x knots
    int evaluations = 0;
};
/// Errors: no such file or not of this form; another trial, other signals or other knots.
Result<EarlierOptimization> read_optimization(const std::filesystem::path& folder, const setup::Setup& setup,
                                              const inverse::ActuationProblem& problem);

/// What lies in optimize.json. Asserts that the optimization is usable, as the others below do.
report::Json optimize_json(const setup::Setup& setup, const calibration::Optimization& optimization,
                           const RunFacts& facts);

/// Writes `<trial>_actuation.csv` in the schema's form, one column for every muscle that follows none, and
/// `<trial>.csv`, the simulated markers. A held signal has two rows at each knot: simulate makes the same run of it.
Result<void> write_actuation(const std::filesystem::path& folder, const setup::Setup& setup,
                             const calibration::Optimization& optimization);

/// The files `<trial>_actuation.csv` that write_actuation() may write, for every trial of the experiment.
std::vector<std::filesystem::path> actuation_files(const std::filesystem::path& folder,
                                                   const experiment::Experiment& experiment);

/// Signals, markers over their targets, how the loss fell.
report::HtmlReport optimize_report(const setup::Setup& setup, const calibration::Optimization& optimization,
                                   const RunFacts& facts);

}  // namespace myo::results
