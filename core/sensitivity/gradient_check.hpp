#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sensitivity/adjoint_run.hpp"

namespace myo::sensitivity {

/// A parameter, or a direction in a field of parameters, along which the gradient is compared with finite differences.
struct CheckedParameter {
    std::string name;
    double step = 0.0;  // of the differences, in the unit of the parameter
    std::function<void(model::Model&, dynamics::SimulationOptions&, double)>
        change;                                              // changes the parameter by the given amount
    std::function<double(const ModelGradient&)> derivative;  // directional derivative from a gradient
};

/// All parameters of a model: moduli, damping, density, Lambda, gravity, forces, attached and directional masses,
/// fibres (stiffness, directions, every knot of the signals within the run), force elements and the start. Vectors and
/// fields are checked along one fixed direction each. The list refers to `model`.
std::vector<CheckedParameter> checked_parameters(const model::Model& model, const dynamics::SimulationOptions& options);

/// Comparison for one parameter.
struct GradientCheckRow {
    std::string name;
    double adjoint = 0.0, difference = 0.0;  // loss per unit of the parameter
    double relative_error = 0.0;             // relative_difference() of both; 0 if both are below the noise of the loss
    bool has_influence = true;               // false: both are below that noise, and nothing was compared
};

/// |a - b| / max(|a|, |b|); 0 if both are 0, infinite if one is not finite.
double relative_difference(double a, double b);
/// Compares the derivatives of a row: by a step over which differences were taken, and a loss that is known to a
/// relative tolerance.
void compare(GradientCheckRow& row, double step, double loss, double tolerance);

/// Result of check_gradient().
struct GradientCheck {
    dynamics::RunStatus status = dynamics::RunStatus::not_run;
    std::string message;
    std::vector<GradientCheckRow> rows;

    /// Whether all rows were computed.
    bool complete() const { return status == dynamics::RunStatus::complete; }
    /// Median of the relative errors (upper median for an even number); 0 without rows.
    double median_error() const;
    /// Largest of the relative errors; 0 without rows.
    double worst_error() const;
};

/// Compares simulate_with_gradient() with central differences of fourth order.
///
/// Four runs per parameter, on up to `threads` threads. Stages and linear solves are solved to 1e-10, because
/// differences amplify the solver noise.
/// Errors: those of the runs, in status and message.
GradientCheck check_gradient(const model::Model& model, dynamics::SimulationOptions options, const LossOfMotion& loss,
                             const std::vector<CheckedParameter>& parameters, AdjointOptions adjoint = {},
                             int threads = 1, const Progress& progress = {});

}  // namespace myo::sensitivity
