#include "diagnosis/diagnosis.hpp"

#include <algorithm>
#include <utility>

#include "base/text.hpp"
#include "diagnosis/diagnosis_policy.hpp"
#include "diagnosis/discretisation/correct_discretisation.hpp"
#include "diagnosis/fit/declared_fit.hpp"
#include "diagnosis/search/search_effects.hpp"
#include "diagnosis/search/search_pairs.hpp"
#include "diagnosis/selection/judgement.hpp"
#include "diagnosis/verdict/verdict.hpp"
#include "effect/catalogue.hpp"
#include "statistics/residual_spot.hpp"

namespace myo::diagnosis {
namespace {

void test(DiagnosisWork& work) {
    work.progress.report({"significance", 1.0, 1.0, "stage", {}});
    work.show();
}

/// Adds a note on where and when most of an unexplained residual occurs, if that is a small part of a recording.
void note_spot(const setup::Setup& setup, Diagnosis& d) {
    const std::optional<statistics::ResidualSpot> spot = d.verdict.kind == VerdictKind::unknown
                                                             ? statistics::residual_spot(d.augmented.fit.residual,
                                                                                         d.data.layout)
                                                             : std::nullopt;
    if (!spot) return;
    std::vector<std::string> markers;
    for (const int marker : spot->markers) markers.push_back(setup.marker_names[static_cast<std::size_t>(marker)]);
    d.notes.push_back(format_number(100.0 * spot->share, 2) + " % of the squared residual lies between " +
                      format_number(spot->from_s, 3) + " and " + format_number(spot->to_s, 3) + " s of " +
                      setup.trials[static_cast<std::size_t>(spot->trial)].name + ", in " + join(markers) +
                      ": look there for a fault of the recording, or for what acted once");
}

/// Verdict, its fit with the numerical error recomputed, and predictions of all trials before and after.
void conclude(DiagnosisWork& work) {
    Diagnosis& result = work.result;
    add_error_of_other_trials(work, result.declared);
    result.numerics = *result.declared.numerics;
    result.augmented = decide(result);
    note_spot(work.setup, result);
    const std::vector<std::size_t> all = work.all_trials();
    const auto scored = [&](const prediction::ParameterValues& fitted, const PredictionShift& shift,
                            std::vector<prediction::TrialPrediction> predictions) {
        for (std::size_t t = 0; t < predictions.size(); ++t)
            predictions[t] = shifted(std::move(predictions[t]), shift, t);
        return prediction::scored_run(work.setup, prediction::with_predicted_levels(work.setup, fitted),
                                      std::move(predictions), all);
    };
    result.before = scored(result.declared.fit.values, result.numerics.shift,
                           work.stage("prediction", 2 * static_cast<int>(all.size()), [&] {
                               return fitted_predictions(work.setup, all, result.declared.fit.values, work.progress);
                           }));
    const ErrorCorrection correction{result.verdict.kind == VerdictKind::effects
                                         ? diagnosis_policy.search.correction.effort
                                         : diagnosis_policy.search.unexplained,
                                     diagnosis_policy.search.correction.most_change};
    if (!result.augmented.numerics && !correct_discretisation(work, result.augmented, "last fit", correction)) return;
    add_error_of_other_trials(work, result.augmented);
    result.data.shift = result.augmented.numerics->shift;
    result.after = result.verdict.kind == VerdictKind::none
                       ? result.before
                       : scored(result.augmented.fit.values, result.augmented.numerics->shift,
                                fitted_predictions(work.setup, all, result.augmented.fit.values, work.progress));
}

}  // namespace

bool may_be_named(const DiagnoseSettings& settings, const std::string& effect) {
    return std::find(settings.without.begin(), settings.without.end(), effect) == settings.without.end();
}

setup::Setup for_candidates(setup::Setup setup, const DiagnoseSettings& settings) {
    const std::vector<effect::Effect>& all = effect::effect_catalogue();
    const bool fine = std::any_of(all.begin(), all.end(), [&](const effect::Effect& effect) {
        return effect.varies_within_cells && may_be_named(settings, effect.id);
    });
    return fine ? setup::with_fine_element(std::move(setup)) : setup;
}

setup::Setup as_diagnosed(const Diagnosis& diagnosis, setup::Setup setup) {
    setup = for_candidates(std::move(setup), diagnosis.settings);
    for (std::size_t t = 0; t < diagnosis.step_factors.size(); ++t)
        setup.trials[t].options.h_s *= diagnosis.step_factors[t];
    setup.modulus_factor = diagnosis.modulus_factor;
    return setup;
}

Diagnosis diagnose(const setup::Setup& setup, const DiagnoseSettings& settings, const Progress& progress,
                   const std::function<void(const Diagnosis&)>& live) {
    const Stopwatch watch;
    DiagnosisWork work(setup, settings, progress, live);
    Diagnosis& result = work.result;
    if (fit_declared(work)) {
        test(work);
        const bool searched = !progress.cancelled() &&
                              needs_explanation(result.declared, result.data, result.numerics,
                                                settings.policy.judgement) &&
                              search_effects(work);
        if (searched && !is_faint(result.declared, result.data, result.numerics, settings.policy.judgement))
            search_pairs(work);
        if (!progress.cancelled()) conclude(work);
    }
    result.stopped = progress.cancelled();
    result.seconds = watch.seconds();
    forget_paths(result.declared.fit.predictions);
    forget_paths(result.augmented.fit.predictions);
    if (!result.stopped) {
        take_over_corrected(result);
        discount_worse_predictions(result);
    }
    return std::move(result);
}

}  // namespace myo::diagnosis
