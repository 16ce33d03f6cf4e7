#include "diagnosis/verdict/final_fit.hpp"

#include <numeric>
#include <utility>
#include <vector>

#include "diagnosis/discretisation/correct_discretisation.hpp"
#include "diagnosis/verdict/neighbouring_places.hpp"
#include "prediction/marker_places.hpp"

namespace myo::diagnosis {
namespace {

/// Scores predictions of all trials with a shift.
prediction::SetupRun shifted_run(const setup::Setup& setup, const prediction::ParameterValues& fitted,
                                 const PredictionShift& shift, std::vector<prediction::TrialPrediction> predictions,
                                 const std::vector<std::size_t>& all) {
    for (std::size_t t = 0; t < predictions.size(); ++t) predictions[t] = shifted(std::move(predictions[t]), shift, t);
    return prediction::scored_run(setup, prediction::with_predicted_levels(setup, fitted), std::move(predictions), all);
}

/// Limits of the last refit: full effort only for effects that are named.
ErrorCorrection correction_of(VerdictKind kind, const SearchPolicy& policy) {
    return {kind == VerdictKind::effects ? policy.correction.effort : policy.unexplained, policy.correction.max_change};
}

}  // namespace

FinalFit final_fit(const FinalFitInput& in, FitStore& store, PhaseLog& log) {
    const DiagnosisContext& context = in.context;
    const setup::Setup& setup = context.setup;
    const VerdictKind kind = in.decision.verdict.kind;
    std::vector<std::size_t> all(setup.trials.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    // The markers where this fit finds them: on its own trials, and nothing is refitted on the others.
    const auto predicted = [&](const JudgedFit& fit, const NumericalError& error) {
        prediction::ParameterValues values = fit.fit.values;
        values.places_m = probable_places(setup, context.data, fit.fit.residual);
        return shifted_run(setup, values, error.shift, fitted_predictions(setup, all, values, log.progress()), all);
    };
    FinalFit result;
    result.fit = in.decision.fit;
    // Also trials that were not fitted: both models predict them without any refit.
    result.before = log.timed("prediction", 2 * static_cast<int>(all.size()),
                              [&] { return predicted(context.declared, in.declared_error); });
    // The fit of the decision was made with this shift.
    FitData data = context.data;
    data.shift = result.fit.numerics ? result.fit.numerics->shift : in.shift;
    if (kind == VerdictKind::effects) result.fit = with_best_place(context, data, std::move(result.fit), store, log);
    if (!result.fit.numerics && kind != VerdictKind::effects && !in.corrects_attempts)
        result.fit.numerics = in.declared_error;
    if (!result.fit.numerics) {
        std::optional<JudgedFit> corrected = correct_discretisation(
            {setup, data, context.settings, context.refinement, "last fit",
             correction_of(kind, context.policy().search)},
            result.fit, store, log);
        if (!corrected) return result;
        result.fit = std::move(*corrected);
        if (!result.fit.numerics) result.fit.numerics = in.declared_error;
    }
    result.fit.numerics = with_error_of_other_trials(context, result.fit, log);
    // With the verdict `none` both models are the declared one.
    result.after = kind == VerdictKind::none ? result.before : predicted(result.fit, *result.fit.numerics);
    const std::vector<Eigen::Vector3d>& places = result.after.values.places_m;
    for (const std::size_t marker : prediction::far_markers(setup, places))
        result.notes.push_back(prediction::far_marker_sentence(setup, marker, places[marker]));
    result.complete = !log.cancelled();
    return result;
}

}  // namespace myo::diagnosis
