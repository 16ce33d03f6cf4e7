#include "setup/signal_span.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "experiment/actuators.hpp"
#include "setup/actuator_signals.hpp"
#include "setup/recording_frame.hpp"

namespace myo::setup {
namespace {

/// Largest less smallest value, in the unit of the signal.
double range_of(const std::vector<double>& values) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    return *most - *least;
}

/// Whether a signal has rows inside the trial, or changes over the trial by more than a small part of its range.
bool meets(const fibre::Signal& signal, double end_s, const SignalSpanPolicy& policy) {
    const double range = range_of(signal.values);
    // A constant signal cannot miss its trial.
    if (!(range > 0.0)) return true;
    for (const double t : signal.times_s)
        if (t > 0.0 && t < end_s) return true;
    return std::abs(signal.value(end_s) - signal.value_before(0.0)) > policy.min_change * range;
}

/// The signal as it would be with its times in another clock or unit: factor * (t - shift_s).
fibre::Signal with_times(fibre::Signal signal, double shift_s, double factor) {
    for (double& t : signal.times_s) t = factor * (t - shift_s);
    return signal;
}

/// Key that declares the signal of an actuator in a trial: of the muscle, of a curve, or of the actuation file.
std::string key_of(const experiment::Experiment& experiment, std::size_t trial, std::size_t actuator,
                   const std::string& name) {
    if (actuator < experiment.muscles.size() && experiment.muscles[actuator].signal)
        return "muscle[" + std::to_string(actuator) + "].signal";
    const std::string path = "trial[" + std::to_string(trial) + "].";
    for (const experiment::ConstantCommand& command : experiment.trials[trial].constant_commands)
        if (command.actuator == name) return path + command.key + "." + name;
    return path + "actuation";
}

// Tries the two usual mistakes: times of the recording's clock, and times in milliseconds.
SignalClock clock_of(const fibre::Signal& signal, const PreparedTrial& trial, double end_s,
                     const SignalSpanPolicy& policy) {
    // Without a shift of the start both clocks are one.
    if (trial.start_s != 0.0 && meets(with_times(signal, trial.start_s, 1.0), end_s, policy))
        return SignalClock::of_the_recording;
    if (meets(with_times(signal, 0.0, 1e-3), end_s, policy)) return SignalClock::milliseconds;
    return SignalClock::unknown;
}

/// Remedy for the clock that explains the times.
std::string advice(const PreparedTrial& trial, const MissedSignal& missed) {
    switch (missed.clock) {
        case SignalClock::of_the_recording:
            return "subtract start_s, " + format_number(trial.start_s, recording_frame_policy.clock_digits) +
                   " s, from its times, which are those of the trace";
        case SignalClock::milliseconds: return "divide its times by 1000 if they are in ms";
        case SignalClock::unknown: break;
    }
    return "give its times in s from there (if they are the trace's or Unix times, less those of t = 0, see start_s)";
}

}  // namespace

std::vector<MissedSignal> missed_signals(const Setup& setup, const SignalSpanPolicy& policy) {
    std::vector<MissedSignal> found;
    const std::vector<experiment::MuscleDeclaration>& muscles = setup.experiment.muscles;
    const std::vector<std::string> names = actuator_names(setup.experiment);
    for (std::size_t t = 0; t < setup.trials.size(); ++t) {
        const PreparedTrial& trial = setup.trials[t];
        const double end_s = trial.measured.time_s.tail(1)(0);
        const std::size_t first_of_trial = found.size();
        for (std::size_t m = 0; m < names.size(); ++m) {
            const fibre::Signal& signal = actuator_signal(setup.experiment, trial.model, m);
            // A follower has no rows of its own: its leader is reported.
            if ((m < muscles.size() && muscles[m].follows) || meets(signal, end_s, policy)) continue;
            const double first = signal.times_s.front(), last = signal.times_s.back();
            const std::string key = key_of(setup.experiment, t, m, names[m]);
            // Actuators of one file share its rows; they are reported in one sentence.
            const auto same = std::find_if(found.begin() + static_cast<std::ptrdiff_t>(first_of_trial), found.end(),
                                           [&](const MissedSignal& other) {
                                               return other.key == key && other.first_s == first &&
                                                      other.last_s == last;
                                           });
            if (same != found.end())
                same->actuators.push_back(names[m]);
            else
                found.push_back({t, key, {names[m]}, first, last, end_s, clock_of(signal, trial, end_s, policy)});
        }
    }
    return found;
}

std::string missed_signal_sentence(const Setup& setup, const MissedSignal& missed) {
    const PreparedTrial& trial = setup.trials[missed.trial];
    const bool all_muscles = std::none_of(
        missed.actuators.begin(), missed.actuators.end(), [&](const std::string& name) {
            return experiment::find_actuator(setup.experiment, name).value_or(0) >= setup.experiment.muscles.size();
        });
    const std::string words = all_muscles ? "muscle" : "actuator";
    const bool many = missed.actuators.size() > 1;
    return missed.key + ": the rows of " + join(missed.actuators) + " run from " +
           format_number(missed.first_s, recording_frame_policy.clock_digits) + " s to " +
           format_number(missed.last_s, recording_frame_policy.clock_digits) + " s and miss trial " + trial.name +
           ", which runs from 0 s to " + format_number(missed.end_s) + " s: the " +
           (many ? words + "s do" : words + " does") + " not move in it. Signals count from the trial's t = 0; " +
           advice(trial, missed);
}

}  // namespace myo::setup
