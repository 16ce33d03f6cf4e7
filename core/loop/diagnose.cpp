#include "loop/diagnosis.hpp"
#include "loop/fit_declared.hpp"
#include "loop/judge.hpp"
#include "loop/search_effects.hpp"
#include "loop/search_pairs.hpp"
#include "loop/settle.hpp"
#include "loop/verdict.hpp"

namespace myo {
namespace {

/// How far the best attempt goes where the verdict is not known.
constexpr Effort attempt_effort{4, 1e-3};

void test(DiagnosisWork& work) {
    work.progress.report({"significance", 1.0, 1.0, "stage", {}});
    work.show();
}

/// The verdict, the fit it stands on with the numerical error taken anew, and all trials before and after.
void conclude(DiagnosisWork& work) {
    Diagnosis& result = work.result;
    foretell_error(work, result.declared);
    result.numerics = *result.declared.numerics;
    result.augmented = decide(result);
    const std::vector<std::size_t> all = work.all_trials();
    const auto scored = [&](const StudyValues& fitted, const PredictionShift& shift, std::vector<TrialPrediction> predictions) {
        for (std::size_t t = 0; t < predictions.size(); ++t) predictions[t] = shifted(std::move(predictions[t]), shift, t);
        return scored_run(work.study, with_predicted_levels(work.study, fitted), std::move(predictions), all);
    };
    result.before = scored(result.declared.fit.values, result.numerics.shift, work.stage("prediction", 2 * static_cast<int>(all.size()), [&] {
        return fitted_predictions(work.study, all, result.declared.fit.values, work.progress);
    }));
    const Settling settling{result.verdict.kind == VerdictKind::effects ? settled_effect.effort : attempt_effort, settled_effect.change};
    if (!result.augmented.numerics && !settle(work, result.augmented, "last fit", settling)) return;
    foretell_error(work, result.augmented);
    result.data.shift = result.augmented.numerics->shift;
    if (result.verdict.kind == VerdictKind::effects) result.verdict.effects = result.augmented.fit.effects;
    result.after = result.verdict.kind == VerdictKind::none ? result.before
                                                            : scored(result.augmented.fit.values, result.augmented.numerics->shift,
                                                                     fitted_predictions(work.study, all, result.augmented.fit.values, work.progress));
    doubt_worse_predictions(result);
}

}  // namespace

Study as_diagnosed(const Diagnosis& diagnosis, Study study) {
    for (StudyTrial& trial : study.trials) trial.options.h_s *= diagnosis.step_factor;
    study.modulus_factor = diagnosis.modulus_factor;
    return study;
}

Diagnosis diagnose(const Study& study, const DiagnoseSettings& settings, const Progress& progress, const std::function<void(const Diagnosis&)>& live) {
    const Stopwatch watch;
    DiagnosisWork work(study, settings, progress, live);
    Diagnosis& result = work.result;
    if (fit_declared(work)) {
        test(work);
        const bool searched = !progress.cancelled() && needs_explanation(result.declared, result.data, result.numerics) && search_effects(work);
        if (searched && !is_faint(result.declared, result.data, result.numerics)) search_pairs(work);
        if (!progress.cancelled()) conclude(work);
    }
    result.stopped = progress.cancelled();
    result.seconds = watch.seconds();
    forget_paths(result.declared.fit.predictions);
    forget_paths(result.augmented.fit.predictions);
    return std::move(result);
}

}  // namespace myo
