#pragma once

#include <functional>

#include "effect/effect.hpp"

namespace myo::effect {

/// Response of an actuator to the input u = a - 1; before t = 0 it is at rest at u(0).
///
/// respond(times, u) returns the responses to samples of u at times that start at 0 and ascend. Two equal times are a
/// jump, over which no time passes. Samples are at most a quarter of the run's step apart; the result is linear between
/// them. It keeps the jump times of the signal even where the response is continuous, so that steps end there.
using Response = std::function<std::vector<double>(const std::vector<double>& times_s, const std::vector<double>& u)>;

/// Predicate for the signals on which an actuator model acts. A lag affects signals that change; a leak affects all
/// that differ from rest anywhere, constant ones included. Other signals are unchanged to the last bit.
using SignalKind = bool (*)(const fibre::Signal&);
/// Whether the signal changes at all.
bool moves(const fibre::Signal& signal);
/// Whether the signal differs from rest (a = 1) anywhere.
bool acts(const fibre::Signal& signal);

/// Replaces all activation signals of this kind by their response.
void respond_to_signals(SignalKind kind, const Response& respond, Affected& affected);

/// Whether any trial has a signal of this kind; otherwise the effect is not observable.
bool any_signal(SignalKind kind, const EffectSearch& search);

}  // namespace myo::effect
