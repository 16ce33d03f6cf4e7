#include "sensitivity/step_coefficients.hpp"

namespace myo::sensitivity {
namespace {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;

Matrix3Xd node(double value) { return Matrix3Xd(Eigen::Vector3d(value, 0.0, 0.0)); }
VectorXd measure(double value) { return VectorXd::Constant(1, value); }
double first(const Matrix3Xd& m) { return m.size() > 0 ? m(0, 0) : 0.0; }
double first(const VectorXd& v) { return v.size() > 0 ? v(0) : 0.0; }

/// Result of one step from a unit value in one nodal field (and the strain field of the same index) or in one stage
/// solution.
struct UnitStep {
    std::vector<double> nodal, strain, inertia_1_s2, rate_factor_1_s;
};

UnitStep unit_step(const dynamics::TimeScheme& scheme, double h, double step_before, double lambda, int column) {
    const auto unit = [&](int field) { return field == column ? 1.0 : 0.0; };
    dynamics::Kinematics start;
    start.x = node(unit(x_field));
    start.v = node(unit(v_field));
    start.v_lag = node(unit(v_lag_field));
    start.force = node(unit(force_field));
    start.force_lag = node(unit(force_lag_field));
    start.strain = measure(unit(strain_field));
    start.rate = measure(unit(rate_field));
    start.rate_lag = measure(unit(rate_lag_field));
    start.step_before_s = step_before;
    model::MassMatrix mass{Eigen::SparseMatrix<double>(1, 1), {}, {}};
    mass.isotropic.insert(0, 0) = 1.0;
    UnitStep result;
    std::vector<double> constants, histories;
    // The stage "solution" is prescribed: the constant and the history show what the step passes to the stage.
    const auto solve = [&](const dynamics::Stage& stage, dynamics::StageSolution& solution) {
        const double value = unit(nodal_fields + static_cast<int>(constants.size()));
        solution = {node(value), measure(value)};
        constants.push_back(first(stage.constant));
        histories.push_back(first(stage.rate_history));
        result.inertia_1_s2.push_back(stage.inertia_1_s2);
        result.rate_factor_1_s.push_back(stage.rate_factor_1_s);
        return true;
    };
    const dynamics::StepProblem<decltype(solve)> problem{mass, 0.0, h, lambda, solve};
    dynamics::Kinematics next;
    dynamics::take_step(scheme, problem, start, next);
    result.nodal = {first(next.x), first(next.v), first(next.v_lag), first(next.force), first(next.force_lag)};
    result.strain = {first(next.strain), first(next.rate), first(next.rate_lag)};
    result.nodal.insert(result.nodal.end(), constants.begin(), constants.end());
    result.strain.insert(result.strain.end(), histories.begin(), histories.end());
    return result;
}

}  // namespace

StepCoefficients step_coefficients(const dynamics::TimeScheme& scheme, double h_s, double step_before_s,
                                   double velocity_force_1_s) {
    StepCoefficients result;
    // A step from zero gives the stage parameters, which do not depend on the state.
    const UnitStep zero = unit_step(scheme, h_s, step_before_s, velocity_force_1_s, -1);
    result.inertia_1_s2 = zero.inertia_1_s2;
    result.rate_factor_1_s = zero.rate_factor_1_s;
    const int stages = result.stages();
    result.nodal.resize(nodal_fields + stages, nodal_fields + stages);
    result.strain.resize(strain_fields + stages, strain_fields + stages);
    for (int column = 0; column < nodal_fields + stages; ++column) {
        const UnitStep step = unit_step(scheme, h_s, step_before_s, velocity_force_1_s, column);
        result.nodal.col(column) = Eigen::Map<const VectorXd>(step.nodal.data(), result.nodal.rows());
        // Strain fields correspond to the first nodal fields: one unit step serves both matrices.
        const int beside = column < strain_fields ? column : column - nodal_fields + strain_fields;
        if (column < strain_fields || column >= nodal_fields)
            result.strain.col(beside) = Eigen::Map<const VectorXd>(step.strain.data(), result.strain.rows());
    }
    return result;
}

StepCoefficients step_coefficients_by_velocity_force(const dynamics::TimeScheme& scheme, double h_s,
                                                     double step_before_s, double velocity_force_1_s) {
    // Central difference; exact for polynomials of degree two. 1/h is the natural unit of Lambda.
    const double change = 1.0 / h_s;
    StepCoefficients up = step_coefficients(scheme, h_s, step_before_s, velocity_force_1_s + change);
    const StepCoefficients down = step_coefficients(scheme, h_s, step_before_s, velocity_force_1_s - change);
    up.nodal = 0.5 * h_s * (up.nodal - down.nodal).eval();
    up.strain = 0.5 * h_s * (up.strain - down.strain).eval();
    for (std::size_t k = 0; k < up.inertia_1_s2.size(); ++k) {
        up.inertia_1_s2[k] = 0.5 * h_s * (up.inertia_1_s2[k] - down.inertia_1_s2[k]);
        up.rate_factor_1_s[k] = 0.0;
    }
    return up;
}

}  // namespace myo::sensitivity
