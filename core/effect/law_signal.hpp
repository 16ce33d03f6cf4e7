#pragma once

#include <memory>
#include <vector>

#include "effect/signal_response.hpp"
#include "law/law.hpp"
#include "law/program.hpp"

namespace myo::effect {

/// A law of signals, compiled once.
struct SignalPrograms {
    law::Law law;
    law::Program initial;  // states at the start
    law::Program rates;    // rates of the states, then their derivatives by the states, row by row
    law::Program signal;
};
/// Compiles a law of signals, with the derivatives of the rates by the states that the implicit method needs.
std::shared_ptr<const SignalPrograms> signal_programs(law::Law law);

/// Response of a law to a signal that is linear between its samples. The states are integrated by the method Radau IIA
/// of fifth order, which is stable for fast states, in equal parts of the time between two samples, so that the
/// response is a smooth function of all parameters. Before t = 0 the signal has the value of its start.
///
/// @param variables  values of parameters, conditions and session_time, one per variable of the law
/// @param times_s  ascending from 0; two equal times are a jump of u
/// @param u        input less its passive value, one per time
/// @return         response less the passive value, one per time; not finite where the law is not
/// Source: Hairer & Wanner 1996, ch. IV.5.
std::vector<double> law_response(const SignalPrograms& law, const std::vector<double>& variables,
                                 const std::vector<double>& times_s, const std::vector<double>& u);

}  // namespace myo::effect
