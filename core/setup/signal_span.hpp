#pragma once

#include <string>
#include <vector>

#include "setup/setup.hpp"

namespace myo::setup {

/// Threshold below which the signal of an actuator is considered to miss its trial.
struct SignalSpanPolicy {
    /// Smallest change over the trial, relative to the range of the signal. With times in ms a trial covers a
    /// thousandth of a ramp, with times of another clock nothing; the motion due to a hundredth of a ramp is below
    /// camera noise.
    double min_change = 0.01;
};

/// Clock under which the times of a signal would overlap its trial.
enum class SignalClock { unknown, of_the_recording, milliseconds };

/// A signal that changes, but not during its trial.
struct MissedSignal {
    std::size_t trial = 0;               // index into Setup::trials
    std::string key;                     // "trial[0].actuation", "trial[0].tension_N.cable", "muscle[1].signal"
    std::vector<std::string> actuators;  // names; same times, same key
    double first_s = 0.0, last_s = 0.0;  // first and last row of the signal; they count from the trial's t = 0
    double end_s = 0.0;                  // last sample of the trial
    SignalClock clock = SignalClock::unknown;
};

/// All such signals, trial by trial: no row between 0 s (excluded) and the last sample of the trial, and hardly any
/// change there. Constant signals, declared steps and followers are skipped.
std::vector<MissedSignal> missed_signals(const Setup& setup, const SignalSpanPolicy& policy = {});

/// Readable warning "<key>: ..." with both time spans and the remedy.
std::string missed_signal_sentence(const Setup& setup, const MissedSignal& missed);

}  // namespace myo::setup
