#pragma once

#include <string>
#include <vector>

#include "base/progress.hpp"
#include "prediction/run_trials.hpp"

namespace myo::prediction {

/// How the step of a trial is chosen where a person asks for none.
struct StepPolicy {
    double most_frequency_error = 1e-3;   // of the vibration that moves the markers most: E errs by twice as much
    double most_noise_share = 1.0 / 3.0;  // of the step's error in traces without such a vibration: a tenth of the
                                          // noise's square
    int most_runs = 8;                    // each with at most ...
    double least_ratio = 0.2;             // ... so short a step as the one before
    int most_probe_steps = 1000;  // of the first look at a vibration that is faster than the camera: 160 periods
    int most_repeats = 2;         // of runs whose vibrations ask for shorter steps
    double safety = 0.9;          // of steps by their error's order
};
inline constexpr StepPolicy step_policy;

/// What a run of the trial shows of its step: the natural vibration that moves the markers most and the step's
/// frequency error in it; of the step alone where markers show no vibration of a third of the noise.
setup::TrialStep step_seen_in(const setup::Setup& setup, std::size_t trial, const ParameterValues& values,
                              const dynamics::Trace& trace);

/// step_seen_in() all trials of a run; a step of 0 where a trial did not complete.
std::vector<setup::TrialStep> steps_seen_in(const setup::Setup& setup, const SetupRun& run);

/// Whether steps are the program's to choose: nobody asked for one, and it is no published formulation, whose damping
/// is that of its step.
bool choosable(const setup::SetupSettings& settings);

/// Steps for all trials with these values, none longer than half a sampling interval and all whole parts of one.
///
/// A trial is run with a whole sampling interval as step, then with half of it, and so on: the change between two runs
/// tells the error of second order, and accelerations tell how much of each natural vibration is in the motion. Where
/// the slowest vibration is too fast to show with these steps, which damp it away, it is looked for with shorter ones
/// first.
///
/// Progress counts trials. Cancelled, what is not chosen yet is half a sampling interval.
/// @param known  a run of the setup with these values: vibrations that it shows need no other. May be null
std::vector<setup::TrialStep> choose_steps(const setup::Setup& setup, const ParameterValues& values,
                                           const Progress& progress = {}, const SetupRun* known = nullptr);

void set_steps(setup::Setup& setup, std::vector<setup::TrialStep> steps);

/// The shortest step of the trials [s].
double shortest_step_s(const setup::Setup& setup);

/// run_trials() with steps that suit the vibrations that it shows: trials whose steps are too long for theirs run again
/// with shorter ones, which are set in the setup. Cheaper than choose_steps(), which looks at the traces' error, too.
/// Steps that are not choosable() stay.
SetupRun run_with_chosen_steps(setup::Setup& setup, const ParameterValues& values, const Progress& progress = {},
                               const std::string& only_trial = {});

}  // namespace myo::prediction
