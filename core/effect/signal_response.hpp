#pragma once

#include <functional>

#include "effect/effect.hpp"

namespace myo::effect {

/// Response of an actuator to the input u: a - 1 of a muscle, pressure of a chamber, command of a tendon. Before t = 0
/// it is at rest at u(0).
///
/// respond(times, u) returns the responses to samples of u at times that start at 0 and ascend. Two equal times are a
/// jump, over which no time passes. Samples are at most a quarter of the run's step apart; the result is linear between
/// them. It keeps the jump times of the signal even where the response is continuous, so that steps end there.
using Response = std::function<std::vector<double>(const std::vector<double>& times_s, const std::vector<double>& u)>;

/// Predicate for the signals on which an actuator model acts. A lag affects signals that change; a leak affects all
/// that differ from rest anywhere, constant ones included. Other signals are unchanged to the last bit.
using SignalKind = bool (*)(const fibre::Signal&, double passive);
/// Whether the signal changes at all.
bool moves(const fibre::Signal& signal, double passive);
/// Whether the signal differs from its passive value anywhere.
bool acts(const fibre::Signal& signal, double passive);

/// The optional parameter `signal` of effects on the actuation: the actuator they act on; absent: all of them.
EffectParameterEntry signal_parameter();

/// Changes all signals on which the parameter `signal` lets an effect act.
///
/// @param change  gets a signal and its passive value: 1 of a muscle, 0 of a chamber or tendon
void change_signals(const TrialContext& context, const EffectParameters& parameters, model::Model& model,
                    const std::function<void(fibre::Signal&, double passive)>& change);

/// Replaces all signals of this kind, as far as the parameter `signal` allows, by their response.
void respond_to_signals(const TrialContext& context, const EffectParameters& parameters, SignalKind kind,
                        const Response& respond, Affected& affected);

/// Whether any trial has a signal of this kind; otherwise the effect is not observable.
bool any_signal(SignalKind kind, const EffectSearch& search);

/// Largest deviation of any signal from its passive value, in the unit of the signal.
double largest_input(const EffectSearch& search);

}  // namespace myo::effect
