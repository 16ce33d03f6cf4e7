#include <cmath>
#include <numbers>

#include "base/text.hpp"
#include "check/checks.hpp"
#include "check/step_level.hpp"
#include "prediction/time_step.hpp"
#include "setup/first_vibration.hpp"
#include "setup/setting_words.hpp"

namespace myo::check {
namespace {

/// Limits of the relative frequency error of a time step.
struct StepPolicy {
    /// Relative frequency errors: the target of choose_steps() with a margin for values that a fit has moved
    /// (ShorterStepsPolicy), and an error that changes a fitted modulus by 2 %.
    double doubtful_error = 1.5 * prediction::step_policy.max_frequency_error;
    double wrong_error = 1e-2;
};
constexpr StepPolicy step_policy;

/// "trial release: steps of 2 ms", the beginning of a sentence.
std::string step_words(const setup::PreparedTrial& trial) {
    return "trial " + trial.name + ": steps of " + format_number(1e3 * trial.options.h_s, 3) + " ms";
}

// A modulus scales with the squared frequency, so its relative error is twice that of the frequency.
/// Finding for a vibration and the relative error of its frequency by the step.
Finding of_vibration(const setup::PreparedTrial& trial, double frequency_Hz, double error) {
    Finding finding = passed_finding(trial.name, step_words(trial) + " make the vibration of " +
                                                     format_number(frequency_Hz, 3) + " Hz " +
                                                     format_number(100.0 * error, 2) + " % too slow");
    finding.figure = error;
    finding.threshold = step_policy.doubtful_error;
    finding.level = step_level(error);
    if (finding.level == CheckLevel::passed) return finding;
    finding.sentence += ", so that a modulus fitted on it is " + format_number(200.0 * error, 2) + " % too high";
    // Second-order scheme: the error grows with the square of the step.
    const double better = trial.options.h_s * std::sqrt(prediction::step_policy.max_frequency_error / error);
    finding.way_out = "choose a step of " + format_number(better, 2) + " s (" + setup::step_setting +
                      "), or leave it to the program";
    return finding;
}

/// Finding for a requested step and a run without visible vibration.
Finding of_nothing_seen(const setup::PreparedTrial& trial, double first_rad_s) {
    const double h = trial.options.h_s;
    // omega h > 1: the scheme damps the first vibration within a few steps, so it could not have been seen.
    const bool blind = first_rad_s * h > 1.0;
    return passed_finding(trial.name, step_words(trial) + ", and no vibration is seen that they could make too slow" +
                                          (blind ? ": they damp away the first one, of " +
                                                       format_number(first_rad_s / (2.0 * std::numbers::pi), 3) +
                                                       " Hz, as suits slow motion"
                                                 : ""));
}

// The step was chosen before the run; its own error estimate is reported.
Finding of_choice(const setup::PreparedTrial& trial, const setup::TrialStep& step) {
    // Without a run of the declared values no step could be chosen.
    if (!step.failure.empty()) {
        Finding finding = passed_finding(
            trial.name,
            step_words(trial) + " are half a sampling interval, for with the declared values " + step.failure);
        finding.level = CheckLevel::doubtful;
        finding.way_out = std::string("choose a step (") + setup::step_setting +
                          "), or declare values nearer the truth";
        return finding;
    }
    // The vibration with the largest motion decides, as a fit follows it.
    if (step.vibration_Hz > 0.0) return of_vibration(trial, step.vibration_Hz, step.frequency_error);
    Finding finding = passed_finding(
        trial.name, step_words(trial) + " err by " + format_number(1e3 * step.trace_error_m, 2) + " mm in the traces");
    finding.figure = step.trace_error_m;
    finding.unit = "m";
    if (!step.settled) {
        finding.level = CheckLevel::doubtful;
        finding.sentence += ", and no shorter ones were tried";
        finding.way_out = std::string("choose a step (") + setup::step_setting + ")";
    }
    return finding;
}

}  // namespace

CheckLevel step_level(double frequency_error) {
    if (frequency_error <= step_policy.doubtful_error) return CheckLevel::passed;
    return frequency_error > step_policy.wrong_error ? CheckLevel::wrong : CheckLevel::doubtful;
}

std::vector<Finding> check_step(const CheckedJob& job) {
    const setup::Setup& setup = job.setup;
    std::vector<Finding> findings;
    std::vector<setup::TrialStep> seen;
    if (job.run != nullptr) seen = job.seen != nullptr ? *job.seen : prediction::steps_seen_in(setup, *job.run);
    for (std::size_t t = 0; t < setup.trials.size(); ++t) {
        const setup::PreparedTrial& trial = setup.trials[t];
        const bool has_run = job.run != nullptr && seen[t].h_s > 0.0;
        // In order of knowledge: the vibration of the run itself, the estimate with which the step was chosen, and for
        // a requested step the first vibration of the body.
        if (has_run && seen[t].vibration_Hz > 0.0)
            findings.push_back(of_vibration(trial, seen[t].vibration_Hz, seen[t].frequency_error));
        else if (t < setup.steps.size())
            findings.push_back(of_choice(trial, setup.steps[t]));
        else if (has_run)
            findings.push_back(of_nothing_seen(
                trial, setup::first_vibration_rad_s(prediction::affected_trial(setup, t, job.run->values).model)));
    }
    return findings;
}

}  // namespace myo::check
