#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "model/force_element.hpp"

namespace myo::model {

// The command of a force element: a signal whose knots are the first parameters of the element. Forces depend on the
// knots through the value of the signal alone, which is linear in them.

/// Value of the command at a state.
double command_value(const fibre::Signal& command, const ForceState& at);
/// Change of that value along a change of the element's parameters.
double command_change(const fibre::Signal& command, const ForceState& at, const Eigen::VectorXd& change);
/// Adds derivatives by the knots, from the derivative by the value: transpose of command_change().
void add_command_work(const fibre::Signal& command, const ForceState& at, double by_value,
                      Eigen::VectorXd& by_parameter);

/// The knots as parameters "<key>, knot <k>"; their scale is the largest magnitude, or `scale` if all are zero.
std::vector<ForceParameter> command_parameters(const fibre::Signal& command, const std::string& key, double scale);
/// Copy of the command with the first entries of `values` at its times.
fibre::Signal with_values(const fibre::Signal& command, const Eigen::VectorXd& values);

/// True if the command is constant throughout (from_s, to_s).
bool constant_between(const fibre::Signal& command, double from_s, double to_s);

}  // namespace myo::model
