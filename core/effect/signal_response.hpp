#pragma once

#include <functional>

#include "effect/effect.hpp"

namespace myo {

/// What an actuator makes of u = a - 1: at rest with u(0) before t = 0, then sample by sample.
///
/// respond(u, h): the responses at times 0, h, 2 h ... to samples of u at these times. The result is linear between samples; h is a quarter of
/// the run's step. A signal that stands still for ever is left as it is.
using Response = std::function<std::vector<double>(const std::vector<double>& u, double h_s)>;
void respond_to_signals(const Response& respond, Affected& affected);

/// Whether any trial's signals move.
bool signals_move(const EffectSearch& search);

}  // namespace myo
