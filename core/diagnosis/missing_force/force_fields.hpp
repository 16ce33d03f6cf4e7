#pragma once

#include <Eigen/Core>

#include <vector>

#include "diagnosis/fit/fit_data.hpp"
#include "setup/trial_effects.hpp"

namespace myo::diagnosis {

/// Body forces that a missing one is put together from: along x, y and z, each weighted by hats over the way from the
/// clamp to the far end.
struct ForceFields {
    std::vector<Eigen::Matrix3Xd> patterns;  // 3 x n each [N per N/m3], zero on clamped nodes
    Eigen::MatrixXd volume;                  // fields x fields [m3]: integral of the product of two
    Eigen::VectorXd place;                   // n: 0 at the clamp, 1 at the far end
};
ForceFields force_fields(const model::Body& body);

/// Courses over time are linear between these times [s].
struct KnotTimes {
    double spacing_s = 0.025;
    int count = 2;

    double end_s() const { return spacing_s * static_cast<double>(count - 1); }
    Eigen::VectorXd times_s() const { return Eigen::VectorXd::LinSpaced(count, 0.0, end_s()); }
};
/// About 25 ms apart, closer in trials under a quarter of a second and wider in those over one and a half.
KnotTimes knot_times(double end_s);

/// The signal with these values at the knots.
fibre::Signal knot_signal(const KnotTimes& knots, const Eigen::VectorXd& values);

/// How a trial's flat residual changes with the fields' sizes at the knots, N x (knots fields), the fields of a knot
/// side by side, to first order about the equilibrium under mean loads and activations: a response to one knot is that
/// to another, later.
///
/// @param data  of this trial alone
/// Empty where no such run completes.
Eigen::MatrixXd force_response(const setup::Setup& setup, const FitData& data,
                               const prediction::ParameterValues& values, const ForceFields& fields,
                               const KnotTimes& knots, const Progress& progress);

}  // namespace myo::diagnosis
