#pragma once

#include <cmath>

#include "diagnosis/diagnosis.hpp"
#include "prediction/predict_trials.hpp"

namespace myo::test {

/// A fit of the declared values as they stand, with Young's modulus as its only parameter.
inline diagnosis::JointFit unmoved_fit(const setup::Setup& setup, const diagnosis::FitData& data,
                                       const prediction::ParameterValues& values) {
    diagnosis::JointFit fit;
    fit.values = values;
    fit.parameters = diagnosis::joint_parameters(setup, values, diagnosis::DeclaredFitPolicy{});
    fit.predictions = prediction::predict_trials_with(setup, values, data.trials, {}, fit.parameters);
    fit.residual = diagnosis::flat_residual(data, fit.predictions);
    fit.jacobian = diagnosis::flat_jacobian(data, fit.predictions, fit.parameters.size());
    fit.report.deviations = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(fit.parameters.size()), std::nan(""));
    fit.effects.assign(values.effects.begin() + static_cast<std::ptrdiff_t>(setup.experiment.effects.size()),
                       values.effects.end());
    return fit;
}

}  // namespace myo::test
