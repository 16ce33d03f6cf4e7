#include "diagnosis/alike_values.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace myo::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Directions that move the data so many times less than others are not used: a number that hardly tells would go
/// anywhere.
constexpr double least_telling = 1e-2;

/// Adds `factor` times what `to` has more than `from`, within the bounds of the numbers.
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

/// Values with the change of all numbers of the fit that undoes a change of the motion.
prediction::ParameterValues undoing(const JointFit& fit, prediction::ParameterValues values, const VectorXd& change) {
    VectorXd size = fit.jacobian.colwise().norm();
    size = (size.array() > 0.0).select(size, 1.0);
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
    solver.setThreshold(least_telling);
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

AlikeValues more_alike(const FitData& data, const JointFit& fit, const NumericalError& error) {
    const AlikeValues with = error.alike ? *error.alike : AlikeValues{fit.values, fit.values, fit.values};
    return {fit.values, undoing(fit, with.finer_step, flat_shift(data, error.step_shift) / step_extrapolation()),
            undoing(fit, with.finer_mesh, flat_shift(data, error.mesh_change))};
}

AlikeValues moved_to(const JointFit& fit, const AlikeValues& alike) {
    return {fit.values, moved(fit.parameters, fit.values, alike.setup, alike.finer_step, 1.0),
            moved(fit.parameters, fit.values, alike.setup, alike.finer_mesh, 1.0)};
}

prediction::ParameterValues at_the_limit(const JointFit& fit, const AlikeValues& alike, double mesh_factor) {
    const prediction::ParameterValues by_step = moved(fit.parameters, fit.values, alike.setup, alike.finer_step,
                                                      step_extrapolation());
    return moved(fit.parameters, by_step, alike.setup, alike.finer_mesh, mesh_factor);
}

}  // namespace myo::diagnosis
