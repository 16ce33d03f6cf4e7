#pragma once

#include <Eigen/Core>

#include <vector>

#include "diagnosis/diagnosis_policy.hpp"
#include "diagnosis/fit/fit_data.hpp"
#include "setup/trial_effects.hpp"

namespace myo::diagnosis {

/// Basis of body forces: along x, y and z, each weighted by hat functions along the body from the clamp to the far end.
struct ForceFields {
    std::vector<Eigen::Matrix3Xd> patterns;  // 3 x n each [N per N/m3], zero on clamped nodes
    Eigen::MatrixXd volume;                  // fields x fields [m3]: integrals of their products
    Eigen::VectorXd place;                   // n: 0 at the clamp, 1 at the far end
};
/// Fields of a body; hat functions at MissingForcePolicy::stations.
ForceFields force_fields(const model::Body& body, const MissingForcePolicy& policy);

/// Knots of courses that are piecewise linear in time.
struct KnotTimes {
    double spacing_s = 0.0;
    int count = 2;

    double end_s() const { return spacing_s * static_cast<double>(count - 1); }
    Eigen::VectorXd times_s() const { return Eigen::VectorXd::LinSpaced(count, 0.0, end_s()); }
};
/// Knots about MissingForcePolicy::knot_spacing_s apart; closer in trials that would have too few of them, wider in
/// those that would have too many.
KnotTimes knot_times(double end_s, const MissingForcePolicy& policy);

/// Basis of forces over body and time.
struct ForceBasis {
    ForceFields fields;
    KnotTimes knots;
};

/// Piecewise linear signal with these values at the knots.
fibre::Signal knot_signal(const KnotTimes& knots, const Eigen::VectorXd& values);

/// Response of a trial's flat residual to the knot values of the fields, N x (knots fields), the fields of a knot
/// adjacent.
///
/// First order about the equilibrium under the mean activations and the loads at the middle of the trial; about the
/// unloaded rest shape if there is no such equilibrium. The response to a knot is that to an earlier one, delayed.
/// @param data  of this trial alone
/// @return      empty if no such run completes
Eigen::MatrixXd force_response(const setup::Setup& setup, const FitData& data,
                               const prediction::ParameterValues& values, const ForceBasis& basis,
                               const MissingForcePolicy& policy, const Progress& progress);

}  // namespace myo::diagnosis
