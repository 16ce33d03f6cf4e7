#pragma once

#include <functional>

#include "effect/effect.hpp"

namespace myo {

/// What an actuator makes of u = a - 1: at rest with u(0) before t = 0, then sample by sample.
///
/// respond(u, h): the responses at times 0, h, 2 h ... to samples of u at these times. The result is linear between
/// samples; h is a quarter of the run's step. Signals that it leaves alone stay as they are, to the last bit.
using Response = std::function<std::vector<double>(const std::vector<double>& u, double h_s)>;

/// Which signals an actuator answers to otherwise than they say: one that follows late those that move, one that loses
/// what it holds all that are anywhere off their rest, constant ones too.
using SignalKind = bool (*)(const Signal&);
bool moves(const Signal& signal);
bool acts(const Signal& signal);

void respond_to_signals(SignalKind kind, const Response& respond, Affected& affected);

/// Whether any trial has a signal of this kind.
bool any_signal(SignalKind kind, const EffectSearch& search);

}  // namespace myo
