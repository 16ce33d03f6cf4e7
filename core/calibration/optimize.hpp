#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "calibration/target_miss.hpp"
#include "inverse/actuation_deviations.hpp"
#include "inverse/actuation_fit.hpp"
#include "prediction/run_trials.hpp"

namespace myo::calibration {

/// How the actuation of a trial is looked for.
struct OptimizeSettings {
    double frequency_Hz = 20.0;            // of the knots
    bool hold = false;                     // constant from knot to knot instead of linear
    std::optional<double> smoothness_m_s;  // see ActuationProblem; default: the noise of the markers times a second
    double lowest = 0.5, highest = 2.0;    // of every muscle's activation, followers included
    int max_evaluations = 100;             // of each start
    int starts = 1;                        // the first is the given one, the others are random levels
    std::uint64_t seed = 1;
    /// Gets what is known after every evaluation of the running start, on the caller's thread. May be empty.
    std::function<void(const inverse::ActuationFit&)> evaluated = {};
};

/// The problem of a setup's only trial (with_one_trial()): one signal for every muscle that follows none, from t = 0 to
/// the last sample. Of a trial that starts at rest under levels that are on no record these are sought, too, and a
/// registration that is not known within its bounds.
/// Errors: no muscles, no samples after the start, knots closer than steps, no values between the bounds,
/// a lowest one of 0 or below but as published.
Result<inverse::ActuationProblem> actuation_problem(const setup::Setup& setup, const OptimizeSettings& settings);

/// How one of several starts ended.
struct StartEnding {
    inverse::FitStatus status = inverse::FitStatus::not_run;
    std::string message;
    double loss_before_m2 = 0.0, loss_after_m2 = 0.0;
    int evaluations = 0;
};

/// The actuation of a trial.
struct Optimization {
    OptimizeSettings settings;
    inverse::ActuationProblem problem;
    inverse::ActuationFit fit;                // of the start that ended with the least loss
    inverse::ActuationDeviations deviations;  // of its values
    std::vector<StartEnding> starts;
    prediction::SetupRun before, after;  // the trial with the first start's values, and with those found; markers only
    TargetMiss miss;                     // what is left
    int earlier_evaluations = 0;         // of the calls that this one resumes
    double seconds = 0.0;
    bool stopped = false;  // by the user
    std::vector<std::string> warnings;

    bool usable() const { return fit.usable(); }
};

/// Looks for the signals from `start` (signals x knots) and from random levels. fit.first is the evaluation of the
/// first start that could be run. Cancelled, it gives the best values so far.
Optimization search_signals(const setup::Setup& setup, const inverse::ActuationProblem& problem,
                            const OptimizeSettings& settings, const Eigen::MatrixXd& start,
                            const Progress& progress = {});

/// What was found beside the target, how well it is determined (not of a search that was stopped), and what a person
/// should know of it.
void judge_signals(const setup::Setup& setup, Optimization& found, const Progress& progress = {});

/// Both, with steps that suit the motion that the search ends with: where half a sampling interval is too long for the
/// vibrations that the signals excite, shorter steps are set in the setup and the search goes on from where it was.
/// Steps that are not choosable() stay. The evaluations of searches before the last count as earlier ones.
Optimization optimize_with_chosen_steps(setup::Setup& setup, const inverse::ActuationProblem& problem,
                                        const OptimizeSettings& settings, const Eigen::MatrixXd& start,
                                        const Progress& progress = {});

/// The only trial run with the signals that were found and with all that simulate looks at. Cancelled, it has not run.
prediction::SetupRun run_with_found_signals(const setup::Setup& setup, const Optimization& found,
                                            const Progress& progress = {});

}  // namespace myo::calibration
