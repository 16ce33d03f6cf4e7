#include "loop/error_finder.hpp"

#include <algorithm>
#include <cmath>

#include "loop/stiffening.hpp"
#include "project/predict_trials.hpp"
#include "project/refined_study.hpp"
#include "project/run_study.hpp"

namespace myo {
namespace {

/// The numerical error is taken off predictions by a mesh of so many unknowns, within these ratios of the edge.
constexpr double fine_unknowns = 8000.0, finest_ratio = 0.5, coarsest_ratio = 0.75;

}  // namespace

void forget_paths(std::vector<TrialPrediction>& predictions) {
    for (TrialPrediction& prediction : predictions) prediction.trace.path.reset();
}

std::vector<TrialPrediction> fitted_predictions(const Study& study, const std::vector<std::size_t>& trials, const StudyValues& fitted, const Progress& progress) {
    std::vector<TrialPrediction> predictions = predict_trials_with(study, with_predicted_levels(study, fitted), trials, progress);
    forget_paths(predictions);
    return predictions;
}

bool ErrorFinder::match(const StudyValues& fitted, const FitData& data, NumericalError& error, const Progress& progress) {
    if (!match_stiffness(study_, with_predicted_levels(study_, fitted), data, error, progress)) return false;
    plain_ = error;
    return true;
}

NumericalError ErrorFinder::at(const StudyValues& fitted, const std::vector<std::size_t>& trials, const NumericalError* known, const Progress& progress,
                               const AlikeValues* alike) {
    if (!refined_ && refine_mesh_) {
        const double ratio = std::clamp(std::cbrt(study_.body->dofs() / fine_unknowns), finest_ratio, coarsest_ratio);
        Result<Study> finer = refined_study(study_, ratio, progress);
        refine_mesh_ = bool(finer);
        if (finer) {
            refined_ = std::make_unique<Study>(std::move(*finer));
            for (std::size_t t = 0; t < study_.trials.size(); ++t) refined_->trials[t].options.h_s = study_.trials[t].options.h_s;
        }
    }
    const AlikeValues same = alike ? *alike : AlikeValues{fitted, fitted, fitted};
    const AlikeValues values{with_predicted_levels(study_, same.study), with_predicted_levels(study_, same.finer_step), with_predicted_levels(study_, same.finer_mesh)};
    const std::vector<TrialPrediction> base = fitted_predictions(study_, trials, same.study, progress);
    NumericalError error = numerical_error(study_, refined_.get(), values, trials, base, known, plain_.stiffening, progress);
    if (alike) {
        const std::vector<TrialPrediction> there = fitted_predictions(study_, trials, fitted, progress);
        for (std::size_t i = 0; i < trials.size(); ++i)
            if (base[i].ok() && there[i].ok() && !error.shift[trials[i]].empty()) add_scaled(difference(base[i], there[i]), 1.0, error.shift[trials[i]]);
        error.alike = *alike;
    }
    if (plain_.stiffening.any()) {   // the cells' own error, as it was without
        error.by_stiffness = plain_.by_stiffness;
        error.step_rms_m = plain_.step_rms_m;
        error.mesh_rms_m = plain_.mesh_rms_m;
    }
    return error;
}

}  // namespace myo
