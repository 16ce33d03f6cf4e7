#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "inverse/actuation_deviations.hpp"
#include "inverse/actuation_fit.hpp"
#include "project/output_json.hpp"
#include "project/run_study.hpp"
#include "project/target_miss.hpp"
#include "report/html_report.hpp"

namespace myo {

/// How the actuation of a trial is looked for.
struct OptimizeSettings {
    double frequency_Hz = 20.0;             // of the knots
    bool hold = false;                      // constant from knot to knot instead of linear
    std::optional<double> smoothness_m_s;   // see ActuationProblem; default: the noise of the markers times a second
    double lowest = 0.5, highest = 2.0;     // of every muscle's activation, followers included
    int max_evaluations = 100;              // of each start
    int starts = 1;                         // the first is the given one, the others are random levels
    std::uint64_t seed = 1;
    /// Gets what is known after every evaluation of the running start, on the caller's thread. May be empty.
    std::function<void(const ActuationFit&)> evaluated = {};
};

/// The problem of a study's only trial (with_one_trial()): one signal for every muscle that follows none, from t = 0 to
/// the last sample. Of a trial that starts at rest under levels that are on no record these are sought, too, and a
/// registration that is not known within its bounds.
/// Errors: no muscles, no samples after the start, knots closer than steps, no values between the bounds,
/// a lowest one of 0 or below but as published.
Result<ActuationProblem> actuation_problem(const Study& study, const OptimizeSettings& settings);

/// How one of several starts ended.
struct StartEnding {
    FitStatus status = FitStatus::not_run;
    std::string message;
    double loss_before_m2 = 0.0, loss_after_m2 = 0.0;
    int evaluations = 0;
};

/// The actuation of a trial.
struct Optimization {
    OptimizeSettings settings;
    ActuationProblem problem;
    ActuationFit fit;                    // of the start that ended with the least loss
    ActuationDeviations deviations;      // of its values
    std::vector<StartEnding> starts;
    StudyRun before, after;              // the trial with the first start's values, and with those found; markers only
    TargetMiss miss;                     // what is left
    int earlier_evaluations = 0;         // of the calls that this one resumes
    double seconds = 0.0;
    bool stopped = false;                // by the user
    std::vector<std::string> warnings;

    bool usable() const { return fit.usable(); }
};

/// Looks for the signals from `start` (signals x knots) and from random levels. fit.first is the evaluation of the
/// first start that could be run. Cancelled, it gives the best values so far.
Optimization search_signals(const Study& study, const ActuationProblem& problem, const OptimizeSettings& settings,
                            const Eigen::MatrixXd& start, const Progress& progress = {});

/// What was found beside the target, how well it is determined (not of a search that was stopped), and what a person
/// should know of it.
void judge_signals(const Study& study, Optimization& found, const Progress& progress = {});

/// Both, with steps that suit the motion that the search ends with: where half a sampling interval is too long for the
/// vibrations that the signals excite, shorter steps are set in the study and the search goes on from where it was.
/// Steps that are not choosable() stay. The evaluations of searches before the last count as earlier ones.
Optimization optimize_with_chosen_steps(Study& study, const ActuationProblem& problem, const OptimizeSettings& settings,
                                        const Eigen::MatrixXd& start, const Progress& progress = {});

/// The only trial run with the signals that were found and with all that simulate looks at. Cancelled, it has not run.
StudyRun run_with_found_signals(const Study& study, const Optimization& found, const Progress& progress = {});

/// Where an earlier call has left off: the values in its optimize.json.
struct EarlierOptimization {
    Eigen::MatrixXd values;   // signals x knots
    int evaluations = 0;
};
/// Errors: no such file or not of this form; another trial, other signals or other knots.
Result<EarlierOptimization> read_optimization(const std::filesystem::path& folder, const Study& study, const ActuationProblem& problem);

/// What lies in optimize.json. Asserts that the optimization is usable, as the others below do.
Json optimize_json(const Study& study, const Optimization& optimization, const RunFacts& facts);

/// Writes `<trial>_actuation.csv` in the schema's form, one column for every muscle that follows none, and `<trial>.csv`, the
/// simulated markers. A held signal has two rows at each knot: simulate makes the same run of it.
Result<void> write_actuation(const std::filesystem::path& folder, const Study& study, const Optimization& optimization);

/// The files `<trial>_actuation.csv` that write_actuation() may write, for every trial of the experiment.
std::vector<std::filesystem::path> actuation_files(const std::filesystem::path& folder, const Experiment& experiment);

/// Signals, markers over their targets, how the loss fell.
HtmlReport optimize_report(const Study& study, const Optimization& optimization, const RunFacts& facts);

}  // namespace myo
