#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sensitivity/adjoint_run.hpp"

namespace myo::sensitivity {

/// A parameter, or a direction in many, along which a gradient is compared with differences.
struct CheckedParameter {
    std::string name;
    double step = 0.0;                                                                // of the differences, in its unit
    std::function<void(model::Model&, dynamics::SimulationOptions&, double)> change;  // by so much
    std::function<double(const ModelGradient&)> derivative;
};

/// All that this model depends on: moduli, damping, density, Lambda, gravity, forces, attached and directional masses,
/// fibres (stiffness, directions, every knot of the signals within the run) and the start. Vectors are taken along one
/// fixed direction each.
std::vector<CheckedParameter> checked_parameters(const model::Model& model, const dynamics::SimulationOptions& options);

struct GradientCheckRow {
    std::string name;
    double adjoint = 0.0, difference = 0.0;
    double relative_error = 0.0;  // relative_difference() of both; 0 where neither changes the loss by its tolerance
};

/// |a - b| over the larger of both; 0 where both are 0.
double relative_difference(double a, double b);

struct GradientCheck {
    dynamics::RunStatus status = dynamics::RunStatus::not_run;
    std::string message;
    std::vector<GradientCheckRow> rows;

    bool complete() const { return status == dynamics::RunStatus::complete; }
    double median_error() const;
    double worst_error() const;
};

/// Compares simulate_with_gradient() with central differences of fourth order: four runs per parameter, on up to
/// `threads` threads. Stages and linear solves are solved to 1e-10, as differences see their noise. Errors: those of
/// the runs.
GradientCheck check_gradient(const model::Model& model, dynamics::SimulationOptions options, const LossOfMotion& loss,
                             const std::vector<CheckedParameter>& parameters, AdjointOptions adjoint = {},
                             int threads = 1, const Progress& progress = {});

}  // namespace myo::sensitivity
