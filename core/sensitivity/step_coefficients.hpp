#pragma once

#include <Eigen/Core>

#include <vector>

#include "dynamics/integrator.hpp"

namespace myo::sensitivity {

/// Fields of Kinematics as rows and columns of StepCoefficients. Momentum-like nodal fields come last.
enum NodalField { x_field, v_field, v_lag_field, force_field, force_lag_field, nodal_fields };
/// Strain fields correspond to the first nodal fields: strain to x, rate to v, rate_lag to v_lag.
enum StrainField { strain_field, rate_field, rate_lag_field, strain_fields };

/// Step of an integrator as a linear map, given the stage solutions: one number per pair of fields.
///
/// Nodal rows: fields after the step, then constants of the stages. Nodal columns: fields before the step, then stage
/// solutions. Strain rows: fields after the step, then rate histories of the stages; strain columns as the nodal ones.
/// A momentum row (forces, constants) takes a motion column (positions, velocities, stage solutions) through the mass
/// matrix; all other entries are plain factors.
struct StepCoefficients {
    Eigen::MatrixXd nodal;                // (nodal_fields + stages) squared
    Eigen::MatrixXd strain;               // (strain_fields + stages) squared
    std::vector<double> inertia_1_s2;     // per stage, see Stage
    std::vector<double> rate_factor_1_s;  // per stage, see Stage

    /// Number of implicit stages per step.
    int stages() const { return static_cast<int>(inertia_1_s2.size()); }
};

/// Rows of momenta: forces and stage constants.
inline bool is_momentum_row(int row) { return row >= force_field; }
/// Columns of motion: positions, velocities and stage solutions.
inline bool is_motion_column(int column) { return column < force_field || column >= nodal_fields; }

/// Coefficients of a step of length h_s after one of length step_before_s.
///
/// Obtained from the integrator's own step on a single node of mass 1, one unit field at a time, so that they cannot
/// disagree with the runs.
StepCoefficients step_coefficients(const dynamics::TimeScheme& scheme, double h_s, double step_before_s,
                                   double velocity_force_1_s);

/// Derivative of the coefficients with respect to Lambda. Exact, because they are at most quadratic in Lambda.
StepCoefficients step_coefficients_by_velocity_force(const dynamics::TimeScheme& scheme, double h_s,
                                                     double step_before_s, double velocity_force_1_s);

}  // namespace myo::sensitivity
