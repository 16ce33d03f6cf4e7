#include "diagnosis/screening/effect_responses.hpp"

#include <mutex>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "base/throttle.hpp"
#include "prediction/prediction.hpp"

namespace myo::diagnosis {
namespace {

/// Prediction of a trial with one more effect; without a run where it does not act or changes the observation only.
prediction::TrialPrediction probed(const UnaffectedRuns& runs, std::size_t i, const effect::EffectDeclaration& effect,
                                   const Progress& progress) {
    const std::size_t trial = runs.data.trials[i];
    const prediction::TrialPrediction& unaffected = runs.predictions[i];
    prediction::TrialPrediction prediction;
    // The response is exactly zero: only what flat_residual() reads is copied.
    if (!effect::acts_on(runs.search.trials[i], effect.parameters)) {
        prediction.status = unaffected.status;
        prediction.residual_m = unaffected.residual_m;
        prediction.places_m = unaffected.places_m;
        return prediction;
    }
    prediction::ParameterValues values = runs.values;
    values.effects.push_back(effect);
    prediction = setup::changes_observation_only(effect)
                     ? prediction::observe_trial(runs.setup, trial, values, unaffected.trace)
                     : prediction::predict_trial(runs.setup, trial, values, {}, progress.with_sink({}),
                                                 unaffected.trace.path);
    prediction.trace = {};  // the memory of many runs
    return prediction;
}

}  // namespace

std::vector<EffectResponse> effect_responses(const UnaffectedRuns& runs,
                                             const std::vector<effect::EffectDeclaration>& effects,
                                             const std::string& task, const Progress& progress) {
    const std::size_t trials = runs.data.trials.size();
    std::vector<std::vector<prediction::TrialPrediction>> predictions(effects.size(),
                                                                      std::vector<prediction::TrialPrediction>(trials));
    std::vector<EffectResponse> responses(effects.size());
    std::mutex mutex;
    Throttle throttle;
    int done = 0;
    const int all = static_cast<int>(effects.size() * trials);
    parallel_tasks(all, runs.setup.settings.threads, [&](int number) {
        if (progress.cancelled()) return;
        // Each task writes to its own element; only times and progress need the mutex.
        const std::size_t e = static_cast<std::size_t>(number) / trials, i = static_cast<std::size_t>(number) % trials;
        const Stopwatch watch;
        predictions[e][i] = probed(runs, i, effects[e], progress);
        const std::lock_guard<std::mutex> lock(mutex);
        responses[e].seconds += watch.seconds();
        if (++done == all || throttle.ready())
            progress.report({task, static_cast<double>(done), static_cast<double>(all), "runs", effects[e].id});
    });
    if (progress.cancelled()) return {};
    // In the difference of two residuals the measurement and the shift cancel.
    const Eigen::VectorXd before = diagnosis::flat_residual(runs.data, runs.predictions);
    for (std::size_t e = 0; e < effects.size(); ++e) {
        for (const prediction::TrialPrediction& prediction : predictions[e])
            if (!prediction.ok()) responses[e].failure = prediction.message;
        if (responses[e].failure.empty())
            responses[e].change = diagnosis::flat_residual(runs.data, predictions[e]) - before;
        predictions[e].clear();
    }
    return responses;
}

}  // namespace myo::diagnosis
