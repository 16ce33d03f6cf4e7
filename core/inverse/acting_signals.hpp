#pragma once

#include <Eigen/Core>

#include <functional>
#include <vector>

#include "inverse/actuation_signals.hpp"
#include "model/model.hpp"
#include "sensitivity/model_gradient.hpp"
#include "sensitivity/model_tangent.hpp"

namespace myo::inverse {

/// Signals that act on a body for those commanded, per actuator; a null function: they act as commanded.
/// The times of the knots may depend on the commands' times, not on their values.
using ActingSignals = std::function<std::vector<fibre::Signal>(const std::vector<fibre::Signal>&)>;

struct ActingSignalsPolicy {
    /// Step of the central differences of the acting signals, over the scale of a signal: actuators respond linearly,
    /// but for hysteresis, whose width is 1e-4 or more; rounding leaves ten digits.
    double step = 1e-6;
    /// Added to the values over their scale, with alternating signs: the knots of what acts depend on whether a command
    /// changes at all.
    double nudge = 1e-9;
};
inline constexpr ActingSignalsPolicy acting_signals_policy;

/// Signals that act for sought values, signals x knots. Their knots are the same for all values.
std::vector<fibre::Signal> acting_commands(const SoughtSignals& sought, const ActingSignals& acting,
                                           const Eigen::MatrixXd& values);

/// Chain rule: derivative with respect to the values from that with respect to the knots of acting_commands().
///
/// @param command  per actuator and knot, see driven_gradient()
/// @return         signals x knots
Eigen::MatrixXd acting_value_gradient(const SoughtSignals& sought, const ActingSignals& acting,
                                      const Eigen::MatrixXd& values, const std::vector<std::vector<double>>& command);

/// The model with these signals of its actuators: first those of its fibre groups, then the commands of as many force
/// elements as there are further signals. Asserts that these elements are driven.
model::Model driven_model(model::Model model, const std::vector<fibre::Signal>& signals);

/// Derivative by the knots of the signals of driven_model(), per actuator.
///
/// @param model  that of the gradient
/// @param count  number of actuators
std::vector<std::vector<double>> driven_gradient(const model::Model& model, const sensitivity::ModelGradient& gradient,
                                                 std::size_t count);

/// Tangents of a model with respect to each value (signal index fastest).
///
/// @param model  driven_model() of the acting commands for these values
std::vector<sensitivity::ModelTangent> value_tangents(const SoughtSignals& sought, const ActingSignals& acting,
                                                      const Eigen::MatrixXd& values, const model::Model& model);

}  // namespace myo::inverse
