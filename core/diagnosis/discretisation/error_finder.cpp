#include "diagnosis/discretisation/error_finder.hpp"

#include <algorithm>
#include <cmath>

#include "diagnosis/diagnosis_policy.hpp"
#include "diagnosis/discretisation/effective_modulus.hpp"
#include "prediction/predict_trials.hpp"
#include "prediction/run_trials.hpp"
#include "setup/refined_setup.hpp"

namespace myo::diagnosis {
namespace {}  // namespace

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

bool ErrorFinder::match(const prediction::ParameterValues& fitted, const FitData& data, NumericalError& error,
                        const Progress& progress) {
    if (!match_modulus(setup_, prediction::with_predicted_levels(setup_, fitted), data, error, progress)) return false;
    plain_ = error;
    return true;
}

NumericalError ErrorFinder::at(const prediction::ParameterValues& fitted, const std::vector<std::size_t>& trials,
                               const NumericalError* known, const Progress& progress, const MatchedValues* matched) {
    if (!refined_ && refine_mesh_) {
        const double ratio = std::clamp(std::cbrt(setup_.body->dofs() / diagnosis_policy.numerics.fine_unknowns),
                                        diagnosis_policy.numerics.finest_ratio,
                                        diagnosis_policy.numerics.coarsest_ratio);
        Result<setup::Setup> finer = setup::refined_setup(setup_, ratio, progress);
        refine_mesh_ = bool(finer);
        if (finer) {
            refined_ = std::make_unique<setup::Setup>(std::move(*finer));
            for (std::size_t t = 0; t < setup_.trials.size(); ++t)
                refined_->trials[t].options.h_s = setup_.trials[t].options.h_s;
        }
    }
    const MatchedValues same = matched ? *matched : MatchedValues{fitted, fitted, fitted};
    const MatchedValues values{prediction::with_predicted_levels(setup_, same.setup),
                               prediction::with_predicted_levels(setup_, same.finer_step),
                               prediction::with_predicted_levels(setup_, same.finer_mesh)};
    const std::vector<prediction::TrialPrediction> base = fitted_predictions(setup_, trials, same.setup, progress);
    NumericalError error = numerical_error(setup_, refined_.get(), values, trials, base, known,
                                           plain_.effective_modulus, progress);
    if (matched) {
        const std::vector<prediction::TrialPrediction> there = fitted_predictions(setup_, trials, fitted, progress);
        for (std::size_t i = 0; i < trials.size(); ++i)
            if (base[i].ok() && there[i].ok() && !error.shift[trials[i]].empty())
                add_scaled(difference(base[i], there[i]), 1.0, error.shift[trials[i]]);
        error.matched = *matched;
    }
    if (plain_.effective_modulus.any()) {  // error of the cells without the effective modulus
        error.by_modulus = plain_.by_modulus;
        error.step_rms_m = plain_.step_rms_m;
        error.mesh_rms_m = plain_.mesh_rms_m;
    }
    return error;
}

}  // namespace myo::diagnosis
