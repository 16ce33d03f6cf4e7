#include "inverse/acting_signals.hpp"

#include <cassert>

namespace myo::inverse {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Derivative of the acting activations by one value: signals with the same knots.
std::vector<fibre::Signal> derivative(const SoughtSignals& sought, const ActingSignals& acting, const MatrixXd& values,
                                      Index value) {
    // Commands are affine in the values: differences of any size are exact.
    const double step = acting ? acting_signals_policy.step : 0.5;
    MatrixXd above = values, below = values;
    above(value) += step;
    below(value) -= step;
    std::vector<fibre::Signal> change = acting_activations(sought, acting, above);
    const std::vector<fibre::Signal> low = acting_activations(sought, acting, below);
    for (std::size_t g = 0; g < change.size(); ++g) {
        assert(change[g].times_s == low[g].times_s);
        for (std::size_t k = 0; k < change[g].values.size(); ++k)
            change[g].values[k] = (change[g].values[k] - low[g].values[k]) / (2.0 * step);
    }
    return change;
}

}  // namespace

std::vector<fibre::Signal> acting_activations(const SoughtSignals& sought, const ActingSignals& acting,
                                              const MatrixXd& values) {
    if (!acting) return activations_of(sought, values);
    MatrixXd moving = values;
    for (Index k = 0; k < values.cols(); ++k)
        moving.col(k).array() += k % 2 == 0 ? acting_signals_policy.nudge : -acting_signals_policy.nudge;
    return acting(activations_of(sought, moving));
}

MatrixXd acting_value_gradient(const SoughtSignals& sought, const ActingSignals& acting, const MatrixXd& values,
                               const std::vector<std::vector<double>>& activation) {
    if (!acting) return value_gradient(sought, activation);
    MatrixXd gradient = MatrixXd::Zero(values.rows(), values.cols());
    for (Index i = 0; i < values.size(); ++i) {
        const std::vector<fibre::Signal> change = derivative(sought, acting, values, i);
        for (std::size_t g = 0; g < change.size(); ++g)
            for (std::size_t k = 0; k < change[g].values.size(); ++k)
                gradient(i) += activation[g][k] * change[g].values[k];
    }
    return gradient;
}

std::vector<sensitivity::ModelTangent> value_tangents(const SoughtSignals& sought, const ActingSignals& acting,
                                                      const MatrixXd& values) {
    std::vector<sensitivity::ModelTangent> tangents(static_cast<std::size_t>(values.size()));
    for (Index i = 0; i < values.size(); ++i)
        tangents[static_cast<std::size_t>(i)].activation = derivative(sought, acting, values, i);
    return tangents;
}

}  // namespace myo::inverse
