#pragma once

#include <Eigen/Core>

#include <vector>

#include "dynamics/integrator.hpp"

namespace myo::sensitivity {

/// Nodal and strain fields of Kinematics as rows and columns of StepCoefficients. Momentum-like fields come last.
enum NodalField { x_field, v_field, v_lag_field, force_field, force_lag_field, nodal_fields };
enum StrainField { strain_field, rate_field, rate_lag_field, strain_fields };

/// An integrator's step as what it is but for the stage solves: a linear map with a number per pair of fields.
///
/// Nodal rows: the fields after the step, then the constants of the stages; columns: the fields before it, then the
/// stage solutions. Strain rows: the fields after the step, then the rate histories of the stages; columns likewise. A
/// row of momenta (forces, constants) takes a column of motion (positions, velocities, stage solutions) through the
/// mass, all others are plain.
struct StepCoefficients {
    Eigen::MatrixXd nodal;
    Eigen::MatrixXd strain;
    std::vector<double> inertia_1_s2;  // per stage
    std::vector<double> rate_factor_1_s;

    int stages() const { return static_cast<int>(inertia_1_s2.size()); }
};

inline bool is_momentum_row(int row) { return row >= force_field; }
inline bool is_motion_column(int column) { return column < force_field || column >= nodal_fields; }

/// Taken from the integrator's own step on a body of one node of mass 1, field by field, so that they cannot disagree
/// with the runs.
StepCoefficients step_coefficients(const dynamics::TimeScheme& scheme, double h_s, double step_before_s,
                                   double velocity_force_1_s);

/// Their derivative with respect to Lambda; exact, as they are at most quadratic in it.
StepCoefficients step_coefficients_by_velocity_force(const dynamics::TimeScheme& scheme, double h_s,
                                                     double step_before_s, double velocity_force_1_s);

}  // namespace myo::sensitivity
