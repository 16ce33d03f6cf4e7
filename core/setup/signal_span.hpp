#pragma once

#include <string>
#include <vector>

#include "setup/setup.hpp"

namespace myo::setup {

/// When the signal of a muscle is said to miss its trial.
struct SignalSpanPolicy {
    /// Part of its range that a signal changes by during a trial, at least. A signal whose times are in ms passes a
    /// thousandth of a ramp while the trial lasts, one by another clock nothing; what a hundredth of a ramp moves is
    /// not seen beside the noise of cameras.
    double least_change = 0.01;
};

/// What the times of a signal would have to be for it to meet its trial.
enum class SignalClock { unknown, of_the_recording, milliseconds };

/// A signal that changes, but not during its trial.
struct MissedSignal {
    std::size_t trial = 0;
    std::string key;                     // that names the signal: "trial[0].actuation", "muscle[1].signal"
    std::vector<std::string> muscles;    // with the same times, under one key
    double first_s = 0.0, last_s = 0.0;  // of its rows; they count from the trial's t = 0
    double end_s = 0.0;                  // of the trial
    SignalClock clock = SignalClock::unknown;
};

/// All of them, trial by trial: no row lies within 0 s to the last sample of the trial, the start itself left out, and
/// the signal hardly changes there. Constant signals, steps of the declaration and followers are none.
std::vector<MissedSignal> missed_signals(const Setup& setup, const SignalSpanPolicy& policy = {});

/// "<key>: ...", with both spans and what to change.
std::string missed_signal_sentence(const Setup& setup, const MissedSignal& missed);

}  // namespace myo::setup
