#pragma once

#include <string>
#include <vector>

#include "base/progress.hpp"
#include "prediction/run_trials.hpp"

namespace myo::prediction {

/// How the time step of a trial is chosen if none is requested.
struct StepPolicy {
    double max_frequency_error = 1e-3;   // of the dominant vibration; the modulus E errs by twice as much
    double max_noise_share = 1.0 / 3.0;  // step error over noise if no vibration is visible: a tenth of its square
    int max_runs = 8;                    // runs per trial
    double min_ratio = 0.2;              // smallest step over the one before
    int max_probe_steps = 1000;          // of the probe for vibrations faster than the camera: 160 periods
    int max_repeats = 2;                 // of runs whose vibrations require shorter steps
    double safety = 0.9;                 // factor on steps predicted from the order of the error
};
inline constexpr StepPolicy step_policy;

/// Longest integer fraction of an interval not longer than h, so that samples fall on steps.
double whole_part(double interval, double h);

/// What a run reveals about its time step: the dominant natural vibration at the markers and the step's frequency error
/// in it. Only h_s is set if the markers show no vibration of at least a third of the noise.
///
/// @param trace  complete run of the trial with `values`
setup::TrialStep step_seen_in(const setup::Setup& setup, std::size_t trial, const ParameterValues& values,
                              const dynamics::Trace& trace);

/// step_seen_in() for all trials of a run; h_s = 0 for trials that did not complete.
std::vector<setup::TrialStep> steps_seen_in(const setup::Setup& setup, const SetupRun& run);

/// Whether the program may choose the steps: none was requested, and the formulation is not a published one, whose
/// damping depends on the step.
bool choosable(const setup::SetupSettings& settings);

/// Chooses the time steps of all trials for these values: at most half a sampling interval, integer fractions of it.
///
/// A trial is run with the sampling interval as step, then with half of it, and so on. The difference of two runs gives
/// the second-order error; accelerations give the share of each natural vibration in the motion. If the slowest
/// vibration is too fast for these steps, which damp it, shorter ones are tried first.
///
/// @param known     a run of the setup with these values: vibrations visible in it need no further run; may be null
/// @param progress  counts trials; if cancelled, steps not chosen yet are half a sampling interval
/// Errors: none; see TrialStep::failure and TrialStep::settled.
std::vector<setup::TrialStep> choose_steps(const setup::Setup& setup, const ParameterValues& values,
                                           const Progress& progress = {}, const SetupRun* known = nullptr);

/// Sets one step per trial in the setup and stores them in Setup::steps.
void set_steps(setup::Setup& setup, std::vector<setup::TrialStep> steps);

/// Shortest time step of the trials [s].
double shortest_step_s(const setup::Setup& setup);

/// run_trials() with steps that resolve the visible vibrations: trials with too long steps run again with shorter ones,
/// which are set in the setup. Cheaper than choose_steps(), which also estimates the error of the traces. Steps that
/// are not choosable() are kept.
SetupRun run_with_chosen_steps(setup::Setup& setup, const ParameterValues& values, const Progress& progress = {},
                               const std::string& only_trial = {});

}  // namespace myo::prediction
