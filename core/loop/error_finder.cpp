#include "loop/error_finder.hpp"

#include <algorithm>
#include <cmath>

#include "project/predict_trials.hpp"
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
    const StudyValues values = with_predicted_levels(study, fitted);
    std::vector<PredictionTask> tasks;
    for (const std::size_t t : trials) tasks.push_back({t, &values});
    std::vector<TrialPrediction> predictions = predict_trials(study, tasks, {}, progress);
    forget_paths(predictions);
    return predictions;
}

NumericalError ErrorFinder::at(const StudyValues& fitted, const std::vector<std::size_t>& trials, const NumericalError* known, const Progress& progress) {
    if (!refined_ && refine_mesh_) {
        const double ratio = std::clamp(std::cbrt(study_.body->dofs() / fine_unknowns), finest_ratio, coarsest_ratio);
        Result<Study> finer = refined_study(study_, ratio, progress);
        refine_mesh_ = bool(finer);
        if (finer) {
            refined_ = std::make_unique<Study>(std::move(*finer));
            for (std::size_t t = 0; t < study_.trials.size(); ++t) refined_->trials[t].options.h_s = study_.trials[t].options.h_s;
        }
    }
    const std::vector<TrialPrediction> base = fitted_predictions(study_, trials, fitted, progress);
    return numerical_error(study_, refined_.get(), with_predicted_levels(study_, fitted), trials, base, known, progress);
}

}  // namespace myo
