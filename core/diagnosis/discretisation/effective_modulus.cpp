#include "diagnosis/discretisation/effective_modulus.hpp"

#include <algorithm>
#include <cmath>

#include "prediction/predict_trials.hpp"

namespace myo::diagnosis {
namespace {

/// Predictions with a modulus factor of the cells.
std::vector<prediction::TrialPrediction> with_factor(setup::Setup setup, const prediction::ParameterValues& values,
                                                     const FitData& data, double factor, const Progress& progress) {
    setup.modulus_factor = factor;
    return prediction::predict_trials_with(setup, values, data.trials, progress);
}

/// Derivative of the predictions with respect to the relative change of the modulus (difference quotient).
PredictionShift derivative(const setup::Setup& setup, const FitData& data,
                           const std::vector<prediction::TrialPrediction>& there,
                           const std::vector<prediction::TrialPrediction>& softer, double step) {
    PredictionShift result(setup.trials.size());
    for (std::size_t i = 0; i < data.trials.size(); ++i)
        add_scaled(difference(softer[i], there[i]), -1.0 / step, result[data.trials[i]]);
    return result;
}

}  // namespace

std::optional<NumericalError> match_modulus(const setup::Setup& setup, const prediction::ParameterValues& values,
                                            const FitData& data, NumericalError error, const NumericsPolicy& policy,
                                            const Progress& progress) {
    const Eigen::VectorXd all = flat_shift(data, error.shift), of_step = flat_shift(data, error.step_shift),
                          finer_mesh = flat_shift(data, error.mesh_change);
    if (all.norm() < policy.min_error_for_modulus * std::sqrt(static_cast<double>(all.size()))) return {};
    const std::vector<prediction::TrialPrediction> there = with_factor(setup, values, data, 1.0, progress),
                                                   softer = with_factor(setup, values, data, 1.0 - policy.modulus_step,
                                                                        progress);
    if (!prediction::all_ok(there) || !prediction::all_ok(softer)) return {};
    const PredictionShift column = derivative(setup, data, there, softer, policy.modulus_step);
    const Eigen::VectorXd flat = flat_shift(data, column);
    const double squares = flat.squaredNorm();
    if (!(squares > 0.0)) return {};
    // Least squares with one column: the relative change of the modulus that is nearest to a shift.
    const auto share = [&](const Eigen::VectorXd& shift) {
        return std::clamp(flat.dot(shift) / squares, -policy.max_modulus_change, policy.max_modulus_change);
    };
    EffectiveModulus found;
    found.mesh = share(all - of_step);
    // What the refinement changes, the finer cells do not need.
    found.finer_mesh = found.mesh - share(finer_mesh);
    found.step = share(of_step);
    // The step error is of second order, so that a step of ratio r has r^2 of it.
    found.finer_step = error.step_ratio * error.step_ratio * found.step;
    const std::vector<prediction::TrialPrediction> matched = with_factor(setup, values, data, found.factor(), progress);
    if (!prediction::all_ok(matched)) return {};
    error.effective_modulus = found;
    error.by_modulus.assign(setup.trials.size(), {});
    for (std::size_t i = 0; i < data.trials.size(); ++i) {
        const std::size_t t = data.trials[i];
        // The run with the factor moves by this much; the rest stays a shift. The contribution of step and of mesh is
        // known to first order only, that of the whole exactly.
        add_scaled(difference(matched[i], there[i]), -1.0, error.shift[t]);
        add_scaled(column[t], -found.step, error.step_shift[t]);
        add_scaled(column[t], found.mesh + found.step, error.by_modulus[t]);
    }
    error.rest_rms_m = shift_rms_m(error.shift);
    return error;
}

}  // namespace myo::diagnosis
