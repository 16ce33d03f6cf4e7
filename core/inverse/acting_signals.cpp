#include "inverse/acting_signals.hpp"

#include <cassert>
#include <utility>

#include "model/force_element.hpp"

namespace myo::inverse {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Derivative of the acting commands by one value: signals with the same knots.
std::vector<fibre::Signal> derivative(const SoughtSignals& sought, const ActingSignals& acting, const MatrixXd& values,
                                      Index value) {
    // Commands are affine in the values: differences of any size are exact.
    const double step = (acting ? acting_signals_policy.step : 0.5) *
                        sought.signals[static_cast<std::size_t>(value % values.rows())].scale;
    MatrixXd above = values, below = values;
    above(value) += step;
    below(value) -= step;
    std::vector<fibre::Signal> change = acting_commands(sought, acting, above);
    const std::vector<fibre::Signal> low = acting_commands(sought, acting, below);
    for (std::size_t g = 0; g < change.size(); ++g) {
        assert(change[g].times_s == low[g].times_s);
        for (std::size_t k = 0; k < change[g].values.size(); ++k)
            change[g].values[k] = (change[g].values[k] - low[g].values[k]) / (2.0 * step);
    }
    return change;
}

}  // namespace

std::vector<fibre::Signal> acting_commands(const SoughtSignals& sought, const ActingSignals& acting,
                                           const MatrixXd& values) {
    if (!acting) return commands_of(sought, values);
    MatrixXd moving = values;
    const Eigen::VectorXd nudge = acting_signals_policy.nudge * signal_scales(sought);
    for (Index k = 0; k < values.cols(); ++k)
        if (k % 2 == 0)
            moving.col(k) += nudge;
        else
            moving.col(k) -= nudge;
    return acting(commands_of(sought, moving));
}

MatrixXd acting_value_gradient(const SoughtSignals& sought, const ActingSignals& acting, const MatrixXd& values,
                               const std::vector<std::vector<double>>& command) {
    if (!acting) return value_gradient(sought, command);
    MatrixXd gradient = MatrixXd::Zero(values.rows(), values.cols());
    for (Index i = 0; i < values.size(); ++i) {
        const std::vector<fibre::Signal> change = derivative(sought, acting, values, i);
        for (std::size_t g = 0; g < change.size(); ++g)
            for (std::size_t k = 0; k < change[g].values.size(); ++k)
                gradient(i) += command[g][k] * change[g].values[k];
    }
    return gradient;
}

model::Model driven_model(model::Model model, const std::vector<fibre::Signal>& signals) {
    const std::size_t groups = model.fibres->size();
    assert(signals.size() >= groups && signals.size() <= groups + model.force_elements.size());
    model.activation.assign(signals.begin(), signals.begin() + static_cast<std::ptrdiff_t>(groups));
    for (std::size_t e = 0; groups + e < signals.size(); ++e) {
        assert(model.force_elements[e]->command() != nullptr);
        model.force_elements[e] = model.force_elements[e]->with_command(signals[groups + e]);
    }
    return model;
}

std::vector<std::vector<double>> driven_gradient(const model::Model& model, const sensitivity::ModelGradient& gradient,
                                                 std::size_t count) {
    std::vector<std::vector<double>> by_knot = gradient.activation;
    for (std::size_t e = 0; by_knot.size() < count; ++e) {
        // The knots of the command are the first parameters of an element.
        const Eigen::VectorXd& all = gradient.force_elements[e];
        const auto knots = static_cast<std::ptrdiff_t>(model.force_elements[e]->command()->values.size());
        by_knot.emplace_back(all.begin(), all.begin() + knots);
    }
    return by_knot;
}

std::vector<sensitivity::ModelTangent> value_tangents(const SoughtSignals& sought, const ActingSignals& acting,
                                                      const MatrixXd& values, const model::Model& model) {
    const std::size_t groups = model.fibres->size();
    std::vector<sensitivity::ModelTangent> tangents;
    for (Index i = 0; i < values.size(); ++i) {
        std::vector<fibre::Signal> change = derivative(sought, acting, values, i);
        sensitivity::ModelTangent& tangent = tangents.emplace_back();
        for (std::size_t e = 0; groups + e < change.size(); ++e) {
            const std::vector<double>& knots = change[groups + e].values;
            Eigen::VectorXd& by_value = tangent.force_elements.emplace_back(
                Eigen::VectorXd::Zero(static_cast<Index>(model.force_elements[e]->parameters().size())));
            by_value.head(static_cast<Index>(knots.size())) = Eigen::Map<const Eigen::VectorXd>(
                knots.data(), static_cast<Index>(knots.size()));
        }
        change.resize(groups);
        tangent.activation = std::move(change);
    }
    return tangents;
}

}  // namespace myo::inverse
