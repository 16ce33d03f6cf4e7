#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "calibration/body_design.hpp"
#include "calibration/sought_items.hpp"
#include "calibration/target_miss.hpp"
#include "experiment/actuators.hpp"
#include "inverse/actuation_deviations.hpp"
#include "inverse/actuation_fit.hpp"
#include "prediction/run_trials.hpp"

namespace myo::calibration {

/// How the actuation of a trial, and the design of its body, is searched for.
struct OptimizeSettings {
    std::vector<SoughtItem> seek = {{SoughtKind::signals}};  // what may change; not empty
    double frequency_Hz = 20.0;                              // of the knots of the signals
    bool hold = false;                                       // piecewise constant instead of linear
    std::optional<double> smoothness_m_s;  // see ActuationProblem; default: noise of the markers times one second
    std::optional<double> lowest;          // bounds of every muscle's activation, followers included;
    double highest = 2.0;                  // lowest: see lowest_activation()
    int max_evaluations = 100;             // per start
    int starts = 1;                        // the first is given, the others are random levels
    std::uint64_t seed = 1;                // of the random starts
    /// Called after every evaluation of the running start, on the caller's thread; may be empty.
    std::function<void(const inverse::ActuationFit&)> evaluated = {};
};

/// Whether the signals of any actuators are sought.
bool seeks_signals(const OptimizeSettings& settings);
/// Whether the signal of an actuator that follows none is sought: by its name, or among all unless it is declared with
/// `sought = false`.
bool seeks_signal(const OptimizeSettings& settings, const experiment::Actuator& actuator);

/// Optimal-control problem of a setup with a single trial (with_one_trial()): one signal per muscle that follows none,
/// per chamber and per tendon that is sought, from t = 0 to the last sample; of a hold one value each, see
/// sought_signals().
///
/// For a trial that starts in equilibrium under unrecorded levels these are unknowns as well; so is a limited
/// registration.
/// Errors: no actuators, none of them sought though signals are, neither recording nor goals (see with_goals()), no
/// samples after the start, knots closer than steps, no values between the bounds, a lowest activation <= 0 unless
/// as_published.
/// @param design  what is sought of the body besides, see body_design()
Result<inverse::ActuationProblem> actuation_problem(const setup::Setup& setup, const OptimizeSettings& settings,
                                                    inverse::Design design = {});

/// Outcome of one start.
struct StartEnding {
    inverse::FitStatus status = inverse::FitStatus::not_run;
    std::string message;
    double loss_before_m2 = 0.0, loss_after_m2 = 0.0;  // loss at the start and at the end
    int evaluations = 0;
};

/// Result of a search for the actuation of a trial.
struct Optimization {
    OptimizeSettings settings;
    inverse::ActuationProblem problem;
    inverse::ActuationFit fit;                // of the start with the lowest loss
    inverse::ActuationDeviations deviations;  // standard deviations of its values
    std::vector<StartEnding> starts;          // of all searches, see optimize_with_chosen_steps()
    prediction::SetupRun before, after;       // with the values of the first start and with those found; markers only
    TargetMiss miss;                          // remaining distance to the target
    std::vector<FoundItem> found;             // what the values of the design mean; of the caller, see found_items()
    int earlier_evaluations = 0;              // evaluations of the searches that were resumed; of the caller
    double seconds = 0.0;
    bool stopped = false;  // cancelled by the user
    std::vector<std::string> warnings;

    bool usable() const { return fit.usable(); }
    int evaluations() const;  // runs with gradients, over all starts
};

/// Minimises the loss from `start` and from random levels.
///
/// @return       fit.first is the evaluation of the first start that could be run; cancelled, the best values so far
/// Errors: none; see Optimization::fit for the status.
Optimization search_signals(const setup::Setup& setup, const inverse::ActuationProblem& problem,
                            const OptimizeSettings& settings, const inverse::ActuationStart& start,
                            const Progress& progress = {});

/// Completes a search result: runs before and after, distance to the target, standard deviations (not after
/// cancellation), warnings. Does nothing if the search is not usable.
void judge_signals(const setup::Setup& setup, Optimization& found, const Progress& progress = {});

/// search_signals() and judge_signals() with time steps suited to the resulting motion. If half a sampling interval is
/// too long for the vibrations that the signals excite, shorter steps are set in the setup and the search continues.
/// Steps that are not choosable() are kept.
///
/// @param setup  receives the final time step
/// @return       one search: its starts are those with long steps, followed by one for each shorter step
Optimization optimize_with_chosen_steps(setup::Setup& setup, const inverse::ActuationProblem& problem,
                                        const OptimizeSettings& settings, const inverse::ActuationStart& start,
                                        const Progress& progress = {});

/// Simulates the trial with signals and design found, with complete output as `simulate` gives it. Cancelled: not run.
prediction::SetupRun run_with_found_signals(const setup::Setup& setup, const Optimization& found,
                                            const Progress& progress = {});

}  // namespace myo::calibration
