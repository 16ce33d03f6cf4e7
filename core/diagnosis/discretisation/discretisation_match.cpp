#include "diagnosis/discretisation/discretisation_match.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace myo::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Adds factor * (to - from) to the values, within the bounds of the parameters.
prediction::ParameterValues moved(const std::vector<prediction::ModelParameter>& parameters,
                                  prediction::ParameterValues values, const prediction::ParameterValues& from,
                                  const prediction::ParameterValues& to, double factor) {
    for (const prediction::ModelParameter& p : parameters) {
        const double value = prediction::value_of(p, values) +
                             factor * (prediction::value_of(p, to) - prediction::value_of(p, from));
        prediction::set_value(p, std::clamp(value, p.parameter.lower, p.parameter.upper), values);
    }
    return values;
}

/// Values with the least-squares step of the fit's parameters that cancels a change of the flat residual, within
/// bounds.
prediction::ParameterValues undoing(const JointFit& fit, prediction::ParameterValues values, const VectorXd& change,
                                    const NumericsPolicy& policy) {
    // Columns are scaled to unit length, so that the threshold on singular values does not depend on units.
    VectorXd size = fit.jacobian.colwise().norm();
    size = (size.array() > 0.0).select(size, 1.0);
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
    solver.setThreshold(policy.min_singular_value);
    solver.compute(fit.jacobian * size.cwiseInverse().asDiagonal());
    const VectorXd step = -solver.solve(change).cwiseQuotient(size);
    for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
        const prediction::ModelParameter& p = fit.parameters[i];
        prediction::set_value(p,
                              std::clamp(prediction::value_of(p, values) + step(static_cast<Index>(i)),
                                         p.parameter.lower, p.parameter.upper),
                              values);
    }
    return values;
}

}  // namespace

MatchedValues match_discretisation(const FitData& data, const JointFit& fit, const NumericalError& error,
                                   const NumericsPolicy& policy) {
    const MatchedValues with = error.matched ? *error.matched : MatchedValues{fit.values, fit.values, fit.values};
    // step_shift is extrapolated to zero step; dividing by the Richardson factor gives the change by half the step.
    return {fit.values,
            undoing(fit, with.finer_step, flat_shift(data, error.step_shift) / step_extrapolation(policy), policy),
            undoing(fit, with.finer_mesh, flat_shift(data, error.mesh_change), policy)};
}

MatchedValues moved_match(const JointFit& fit, const MatchedValues& matched) {
    return {fit.values, moved(fit.parameters, fit.values, matched.setup, matched.finer_step, 1.0),
            moved(fit.parameters, fit.values, matched.setup, matched.finer_mesh, 1.0)};
}

prediction::ParameterValues extrapolated_values(const JointFit& fit, const MatchedValues& matched, double mesh_factor,
                                                const NumericsPolicy& policy) {
    const prediction::ParameterValues by_step = moved(fit.parameters, fit.values, matched.setup, matched.finer_step,
                                                      step_extrapolation(policy));
    return moved(fit.parameters, by_step, matched.setup, matched.finer_mesh, mesh_factor);
}

}  // namespace myo::diagnosis
