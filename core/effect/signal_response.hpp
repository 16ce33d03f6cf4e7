#pragma once

#include <functional>

#include "effect/effect.hpp"

namespace myo::effect {

/// What an actuator makes of u = a - 1: at rest with u(0) before t = 0, then sample by sample.
///
/// respond(times, u): the responses to samples of u at these times, which begin at 0 and ascend; two equal ones are a
/// jump, across which no time passes. Samples are a quarter of the run's step apart or less, and the result is linear
/// between them. It has the jumps of the signal, also where the response only bends: steps end there. Signals that it
/// leaves alone stay as they are, to the last bit.
using Response = std::function<std::vector<double>(const std::vector<double>& times_s, const std::vector<double>& u)>;

/// Which signals an actuator answers to otherwise than they say: one that follows late those that move, one that loses
/// what it holds all that are anywhere off their rest, constant ones too.
using SignalKind = bool (*)(const fibre::Signal&);
bool moves(const fibre::Signal& signal);
bool acts(const fibre::Signal& signal);

void respond_to_signals(SignalKind kind, const Response& respond, Affected& affected);

/// Whether any trial has a signal of this kind.
bool any_signal(SignalKind kind, const EffectSearch& search);

}  // namespace myo::effect
