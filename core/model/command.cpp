#include "model/command.hpp"

#include <algorithm>
#include <cmath>

namespace myo::model {

using Eigen::Index;
using Eigen::VectorXd;

double command_value(const fibre::Signal& command, const ForceState& at) {
    return at.before_jump ? command.value_before(at.time_s) : command.value(at.time_s);
}

// The value is linear in the two knots around the time, with weights that do not depend on values.
double command_change(const fibre::Signal& command, const ForceState& at, const VectorXd& change) {
    const fibre::Signal::Weights w = command.weights(at.time_s, at.before_jump);
    const double left = change(static_cast<Index>(w.left));
    return w.left == w.right ? left : w.of_left * left + w.of_right * change(static_cast<Index>(w.right));
}

void add_command_work(const fibre::Signal& command, const ForceState& at, double by_value, VectorXd& by_parameter) {
    const fibre::Signal::Weights w = command.weights(at.time_s, at.before_jump);
    by_parameter(static_cast<Index>(w.left)) += w.of_left * by_value;
    if (w.right != w.left) by_parameter(static_cast<Index>(w.right)) += w.of_right * by_value;
}

std::vector<ForceParameter> command_parameters(const fibre::Signal& command, const std::string& key, double scale) {
    double largest = 0.0;
    for (const double value : command.values) largest = std::max(largest, std::abs(value));
    std::vector<ForceParameter> knots;
    for (std::size_t k = 0; k < command.values.size(); ++k)
        knots.push_back({key + ", knot " + std::to_string(k), command.values[k], largest > 0.0 ? largest : scale});
    return knots;
}

fibre::Signal with_values(const fibre::Signal& command, const VectorXd& values) {
    const auto count = static_cast<std::ptrdiff_t>(command.times_s.size());
    return {command.times_s, {values.begin(), values.begin() + count}};
}

bool constant_between(const fibre::Signal& command, double from_s, double to_s) {
    const auto inside = [&](double t) { return t > from_s && t < to_s; };
    return command.value(from_s) == command.value_before(to_s) &&
           std::none_of(command.times_s.begin(), command.times_s.end(), inside);
}

}  // namespace myo::model
