#include "prediction/time_step.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>
#include <optional>
#include <utility>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "dynamics/numerical_damping.hpp"
#include "prediction/predict_trials.hpp"
#include "prediction/vibration_in_motion.hpp"
#include "setup/first_vibration.hpp"

namespace myo::prediction {
namespace {

/// Relative frequency error of a scheme for an undamped vibration at step h.
double frequency_error(const dynamics::TimeScheme& scheme, double omega, double h_s) {
    return std::abs(dynamics::discrete_vibration(scheme, {omega}, h_s).frequency_error);
}

/// Longest step up to `longest` that keeps the frequency error within the policy. Bisection: the error grows
/// monotonically with the step.
double step_for(const dynamics::TimeScheme& scheme, double omega, double longest) {
    if (frequency_error(scheme, omega, longest) <= step_policy.max_frequency_error) return longest;
    double low = 0.0, high = longest;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (low + high);
        (frequency_error(scheme, omega, middle) <= step_policy.max_frequency_error ? low : high) = middle;
    }
    return low;
}

/// Error in the traces, rms, due to the frequency error and the numerical damping of one vibration. Both accumulate
/// linearly until the vibration has decayed; the phase error is limited to the full amplitude.
double trace_error(const dynamics::TimeScheme& scheme, const Vibration& vibration, double h_s, double end_s) {
    const dynamics::DiscreteVibration discrete = dynamics::discrete_vibration(scheme, {vibration.omega_rad_s}, h_s);
    const double lasts_s = std::min(end_s, 0.5 / (vibration.damping_ratio * vibration.omega_rad_s));
    const double turned_rad = std::hypot(discrete.frequency_error, discrete.damping_ratio) * vibration.omega_rad_s *
                              lasts_s;
    return vibration.amplitude_m * std::min(1.0, turned_rad);
}

double omega_of(const setup::TrialStep& step) { return 2.0 * std::numbers::pi * step.vibration_Hz; }

/// Half a sampling interval, or a shorter step at which the slowest natural vibration would be visible if excited.
double probe_step(const setup::Setup& setup, std::size_t index, const ParameterValues& values) {
    const setup::PreparedTrial& trial = setup.trials[index];
    const double interval = setup::sampling_interval_s(trial), half = 0.5 * interval;
    if (trial.hold) return half;
    const double omega = setup::first_vibration_rad_s(affected_trial(setup, index, values).model);
    // omega h <= 1: the step resolves this vibration well enough to detect it.
    if (!(omega * half > 1.0)) return half;
    return whole_part(interval,
                      std::min(half, std::max(1.0 / omega, trial.options.end_s / step_policy.max_probe_steps)));
}

/// Step for the vibration visible in a run, not longer than the step of the run; empty if none is visible.
std::optional<setup::TrialStep> step_for_seen(const setup::Setup& setup, std::size_t index,
                                              const ParameterValues& values, const TrialPrediction& run) {
    if (!run.ok() || !run.trace.complete()) return std::nullopt;
    setup::TrialStep step = step_seen_in(setup, index, values, run.trace);
    if (!(step.vibration_Hz > 0.0) || omega_of(step) * step.h_s > 1.0) return std::nullopt;
    const dynamics::TimeScheme scheme = setup.trials[index].options.integrator;
    step.h_s = whole_part(setup::sampling_interval_s(setup.trials[index]), step_for(scheme, omega_of(step), step.h_s));
    step.frequency_error = frequency_error(scheme, omega_of(step), step.h_s);
    return step;
}

/// Iteration over steps for one trial: run, estimate the error, shorten the step until the error is allowed.
setup::TrialStep choose_step(setup::Setup& setup, std::size_t index, const ParameterValues& values,
                             const Progress& progress) {
    setup::PreparedTrial& trial = setup.trials[index];
    const double interval = setup::sampling_interval_s(trial), noise = setup::mean_noise(setup);
    const dynamics::TimeScheme scheme = trial.options.integrator;
    setup::TrialStep step;
    step.h_s = 0.5 * interval;
    const auto run = [&](double h) {
        setup::set_step(trial, h);
        return predict_trial(setup, index, values, {}, progress);
    };
    // A run with long steps may have damped a fast vibration away; a probe with a shorter step looks for it first.
    std::optional<TrialPrediction> probed;
    const double probe = probe_step(setup, index, values);
    if (probe < step.h_s) {
        TrialPrediction fine = run(probe);
        if (fine.ok() && step_seen_in(setup, index, values, fine.trace).vibration_Hz > 0.0) {
            step.h_s = probe;
            probed = std::move(fine);
        }
    }
    double h_before = 2.0 * step.h_s;
    // A visible vibration gives the error by its frequency, so the second run for a difference is not needed.
    TrialPrediction before = probed ? TrialPrediction{} : run(h_before);
    for (int runs = 1; runs < step_policy.max_runs; ++runs) {
        const TrialPrediction now = probed ? *std::exchange(probed, std::nullopt) : run(step.h_s);
        if (!now.ok()) {
            step = {};
            step.h_s = 0.5 * interval;
            step.failure = now.message;
            return step;
        }
        const double allowed_m = step_policy.max_noise_share * noise;
        step = step_seen_in(setup, index, values, now.trace);
        double needed = step.h_s;
        if (step.vibration_Hz > 0.0) {
            needed = step_for(scheme, omega_of(step), step.h_s);
        } else {
            // Second-order scheme: the difference of two runs is (ratio^2 - 1) times the error of the finer one
            // (Richardson). If the coarse run failed there is no difference; a large error forces another run.
            const double ratio = h_before / step.h_s;
            step.trace_error_m = before.ok() ? rms_between(before, now) / (ratio * ratio - 1.0) : 10.0 * noise;
            if (step.trace_error_m > allowed_m)
                needed = step_policy.safety * step.h_s * std::sqrt(allowed_m / step.trace_error_m);
        }
        if (needed >= step.h_s) return step;
        // A step is reduced by a limited factor per run: error estimates at coarse steps are unreliable.
        h_before = step.h_s;
        step.h_s = whole_part(interval, std::max(needed, step_policy.min_ratio * step.h_s));
        // omega h < 1 at the previous step: the vibration was identified reliably, so the step need not be verified by
        // a run.
        if (step.h_s <= needed && step.vibration_Hz > 0.0 && omega_of(step) * h_before < 1.0) {
            step.frequency_error = frequency_error(scheme, omega_of(step), step.h_s);
            return step;
        }
        before = now;
    }
    // The number of runs is exhausted; the last step is used and marked.
    step.settled = false;
    return step;
}

}  // namespace

double whole_part(double interval, double h) { return interval / std::ceil(interval / h * (1.0 - 1e-9)); }

setup::TrialStep step_seen_in(const setup::Setup& setup, std::size_t trial, const ParameterValues& values,
                              const dynamics::Trace& trace) {
    setup::TrialStep step;
    step.h_s = setup.trials[trial].options.h_s;
    if (setup.trials[trial].hold) return step;  // at rest
    const std::vector<Vibration> all = vibrations_in(affected_trial(setup, trial, values).model, setup.markers, trace);
    // A vibration below a third of the noise is not distinguishable in the recording.
    if (all.empty() || !(all.front().amplitude_m > step_policy.max_noise_share * setup::mean_noise(setup))) return step;
    const Vibration& largest = all.front();
    const dynamics::TimeScheme scheme = setup.trials[trial].options.integrator;
    step.vibration_Hz = largest.omega_rad_s / (2.0 * std::numbers::pi);
    step.vibration_m = largest.amplitude_m;
    step.frequency_error = frequency_error(scheme, largest.omega_rad_s, step.h_s);
    for (std::size_t i = 1; i < all.size(); ++i)
        step.other_vibrations_m = std::hypot(step.other_vibrations_m,
                                             trace_error(scheme, all[i], step.h_s, trace.times_s.back()));
    return step;
}

std::vector<setup::TrialStep> steps_seen_in(const setup::Setup& setup, const SetupRun& run) {
    std::vector<setup::TrialStep> steps(setup.trials.size());
    for (std::size_t t = 0; t < steps.size(); ++t)
        if (run.predictions[t].ok() && run.predictions[t].trace.complete())
            steps[t] = step_seen_in(setup, t, run.values, run.predictions[t].trace);
    return steps;
}

bool choosable(const setup::SetupSettings& settings) { return !settings.h_s && !settings.as_published; }

std::vector<setup::TrialStep> choose_steps(const setup::Setup& setup, const ParameterValues& values,
                                           const Progress& progress, const SetupRun* known) {
    std::vector<setup::TrialStep> steps(setup.trials.size());
    const auto count = static_cast<int>(steps.size());
    double done = 0.0;
    std::mutex mutex;
    parallel_tasks(count, setup.settings.threads, [&](int index) {
        const auto i = static_cast<std::size_t>(index);
        steps[i].h_s = 0.5 * setup::sampling_interval_s(setup.trials[i]);
        if (setup.trials[i].hold || progress.cancelled()) return;  // a pose has no steps
        std::optional<setup::TrialStep> seen = known ? step_for_seen(setup, i, values, known->predictions[i])
                                                     : std::nullopt;
        setup::Setup own = setup;  // own copy, as trial steps are changed in it
        steps[i] = seen ? *seen : choose_step(own, i, values, progress.with_sink({}));
        const std::lock_guard<std::mutex> lock(mutex);
        progress.report({"choosing the time step", ++done, static_cast<double>(count), "trials", {}});
    });
    return steps;
}

void set_steps(setup::Setup& setup, std::vector<setup::TrialStep> steps) {
    for (std::size_t t = 0; t < steps.size(); ++t) setup::set_step(setup.trials[t], steps[t].h_s);
    setup.steps = std::move(steps);
}

double shortest_step_s(const setup::Setup& setup) {
    double shortest = setup.trials.front().options.h_s;
    for (const setup::PreparedTrial& trial : setup.trials) shortest = std::min(shortest, trial.options.h_s);
    return shortest;
}

SetupRun run_with_chosen_steps(setup::Setup& setup, const ParameterValues& values, const Progress& progress,
                               const std::string& only_trial) {
    if (!choosable(setup.settings)) return run_trials(setup, values, progress, only_trial);
    for (std::size_t t = 0; t < setup.trials.size(); ++t)
        if (only_trial.empty() || setup.trials[t].name == only_trial)
            setup::set_step(setup.trials[t], std::min(setup.trials[t].options.h_s, probe_step(setup, t, values)));
    // A first run with the provisional steps shows which vibrations are excited.
    SetupRun run = run_trials(setup, values, progress, only_trial);
    const Stopwatch watch;
    std::vector<std::size_t> asked;
    for (std::size_t t = 0; t < setup.trials.size(); ++t)
        if (run.predictions[t].status != dynamics::RunStatus::not_run) asked.push_back(t);
    std::vector<std::size_t> open = asked;
    for (int repeat = 0; repeat < step_policy.max_repeats && !progress.cancelled(); ++repeat) {
        // Only trials whose visible vibration needs a shorter step run again.
        std::erase_if(open, [&](std::size_t t) {
            if (!run.predictions[t].ok()) return true;
            setup::PreparedTrial& trial = setup.trials[t];
            const setup::TrialStep step = step_seen_in(setup, t, values, run.predictions[t].trace);
            if (!(step.vibration_Hz > 0.0)) return true;
            const double needed = step_for(trial.options.integrator, omega_of(step), step.h_s);
            if (needed >= step.h_s) return true;
            setup::set_step(trial, whole_part(setup::sampling_interval_s(trial), needed));
            return false;
        });
        if (open.empty()) break;
        std::vector<TrialPrediction> again = predict_trials_with(setup, values, open, progress);
        for (std::size_t i = 0; i < open.size(); ++i) run.predictions[open[i]] = std::move(again[i]);
    }
    // Scores are computed once, from the final predictions.
    const double seconds = run.seconds + watch.seconds();
    run = scored_run(setup, values, std::move(run.predictions), asked);
    run.seconds = seconds;
    return run;
}

}  // namespace myo::prediction
