#include "diagnosis/discretisation/refinement.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "prediction/predict_trials.hpp"
#include "prediction/run_trials.hpp"
#include "setup/refined_setup.hpp"

namespace myo::diagnosis {

void forget_paths(std::vector<prediction::TrialPrediction>& predictions) {
    for (prediction::TrialPrediction& prediction : predictions) prediction.trace.path.reset();
}

std::vector<prediction::TrialPrediction> fitted_predictions(const setup::Setup& setup,
                                                            const std::vector<std::size_t>& trials,
                                                            const prediction::ParameterValues& fitted,
                                                            const Progress& progress) {
    std::vector<prediction::TrialPrediction> predictions = prediction::predict_trials_with(
        setup, prediction::with_predicted_levels(setup, fitted), trials, progress);
    forget_paths(predictions);
    return predictions;
}

Refinement refined(const setup::Setup& setup, bool refine_mesh, const NumericsPolicy& policy,
                   const Progress& progress) {
    if (!refine_mesh) return {};
    // Unknowns grow with the cube of 1 / ratio.
    const double ratio = std::clamp(std::cbrt(setup.body->dofs() / policy.fine_unknowns), policy.finest_ratio,
                                    policy.coarsest_ratio);
    Result<setup::Setup> finer = setup::refined_setup(setup, ratio, progress);
    if (!finer) return {};
    // Preparation would choose steps of its own; the two errors are separated only if the steps are equal.
    for (std::size_t t = 0; t < setup.trials.size(); ++t) finer->trials[t].options.h_s = setup.trials[t].options.h_s;
    return {std::make_shared<const setup::Setup>(std::move(*finer)), {}};
}

NumericalError error_at(const ErrorTask& task, const NumericsPolicy& policy, const Progress& progress) {
    const auto& [setup, refinement, fitted, trials, known, matched] = task;
    const NumericalError& unmatched = refinement.unmatched;
    // Levels of validation trials follow from the values of each run.
    const MatchedValues same = matched ? *matched : MatchedValues{fitted, fitted, fitted};
    const MatchedValues values{prediction::with_predicted_levels(setup, same.setup),
                               prediction::with_predicted_levels(setup, same.finer_step),
                               prediction::with_predicted_levels(setup, same.finer_mesh)};
    const prediction::ParameterValues there = prediction::with_predicted_levels(setup, fitted);
    NumericalError error = numerical_error(
        {setup, refinement.finer.get(), values, matched ? &there : nullptr, trials, known, unmatched.effective_modulus},
        policy, progress);
    if (matched) error.matched = *matched;
    if (unmatched.effective_modulus.any()) {  // error of the cells without the effective modulus
        error.by_modulus = unmatched.by_modulus;
        error.step_rms_m = unmatched.step_rms_m;
        error.mesh_rms_m = unmatched.mesh_rms_m;
    }
    return error;
}

}  // namespace myo::diagnosis
