#pragma once

#include <Eigen/Core>

#include <functional>
#include <vector>

#include "inverse/actuation_signals.hpp"
#include "sensitivity/model_tangent.hpp"

namespace myo::inverse {

/// Activations that act on a body for those commanded, per fibre group; a null function: they act as commanded.
/// The times of the knots may depend on the commands' times, not on their values.
using ActingSignals = std::function<std::vector<fibre::Signal>(const std::vector<fibre::Signal>&)>;

struct ActingSignalsPolicy {
    /// Step of the central differences of the acting signals: actuators respond linearly, but for hysteresis, whose
    /// width is 1e-4 or more; rounding leaves ten digits.
    double step = 1e-6;
    /// Added to the values, with alternating signs: the knots of what acts depend on whether a command changes at all.
    double nudge = 1e-9;
};
inline constexpr ActingSignalsPolicy acting_signals_policy;

/// Activations that act for sought values, signals x knots. Their knots are the same for all values.
std::vector<fibre::Signal> acting_activations(const SoughtSignals& sought, const ActingSignals& acting,
                                              const Eigen::MatrixXd& values);

/// Chain rule: derivative with respect to the values from that with respect to the knots of acting_activations().
///
/// @param activation  per fibre group and knot
/// @return            signals x knots
Eigen::MatrixXd acting_value_gradient(const SoughtSignals& sought, const ActingSignals& acting,
                                      const Eigen::MatrixXd& values,
                                      const std::vector<std::vector<double>>& activation);

/// Tangents of a model with respect to each value (signal index fastest).
std::vector<sensitivity::ModelTangent> value_tangents(const SoughtSignals& sought, const ActingSignals& acting,
                                                      const Eigen::MatrixXd& values);

}  // namespace myo::inverse
