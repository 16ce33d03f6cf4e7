#include "diagnosis/screening/effect_scores.hpp"

#include <atomic>
#include <mutex>
#include <utility>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "base/throttle.hpp"
#include "diagnosis/missing_force/peak_energy.hpp"
#include "diagnosis/screening/marker_scan.hpp"
#include "diagnosis/screening/probe_score.hpp"
#include "diagnosis/screening/residual_lines.hpp"
#include "effect/catalogue.hpp"
#include "prediction/predict_trials.hpp"

namespace myo::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Probe {
    const effect::Effect* effect = nullptr;
    effect::EffectProbe probe;
};

/// One column of a probe with its predictions.
struct ProbeColumn {
    std::size_t probe = 0;  // index
    Index number = 0;       // among the columns of the probe
    prediction::ParameterValues values;
    std::vector<prediction::TrialPrediction> predictions;  // per trial of the data
};

/// Probes of the given size of all allowed effects.
std::vector<Probe> chosen_probes(const effect::EffectSearch& search, const EffectFilter& allowed, ProbeSize size) {
    std::vector<Probe> probes;
    for (const effect::Effect& effect : effect::effect_catalogue()) {
        if (!effect.probes || !allowed(effect.id)) continue;
        for (effect::EffectProbe& probe : effect.probes(search))
            if (probe.large == (size == ProbeSize::large)) probes.push_back({&effect, std::move(probe)});
    }
    return probes;
}

std::vector<ProbeColumn> columns_of(const std::vector<Probe>& probes, const prediction::ParameterValues& values,
                                    std::size_t trials) {
    std::vector<ProbeColumn> columns;
    for (std::size_t p = 0; p < probes.size(); ++p)
        for (std::size_t c = 0; c < probes[p].probe.columns.size(); ++c) {
            ProbeColumn column{p, static_cast<Index>(c), values, std::vector<prediction::TrialPrediction>(trials)};
            column.values.effects.push_back({probes[p].effect->id, probes[p].probe.columns[c]});
            columns.push_back(std::move(column));
        }
    return columns;
}

/// Prediction of a trial with a probe; without a run where the probe does not act or changes the observation only.
prediction::TrialPrediction probed(const setup::Setup& setup, std::size_t trial, const effect::TrialContext& site,
                                   const prediction::ParameterValues& values,
                                   const prediction::TrialPrediction& unaffected, const Progress& progress) {
    const effect::EffectDeclaration& effect = values.effects.back();
    if (!effect::acts_on(site, effect.parameters)) return unaffected;
    if (setup::changes_observation_only(effect))
        return prediction::observe_trial(setup, trial, values, unaffected.trace);
    return prediction::predict_trial(setup, trial, values, {}, progress.with_sink({}), unaffected.trace.path);
}

/// Runs all columns in all trials in parallel; adds the time of each to its score.
void run_columns(const setup::Setup& setup, const FitData& data, const effect::EffectSearch& search,
                 const std::vector<prediction::TrialPrediction>& unaffected, std::vector<ProbeColumn>& columns,
                 std::vector<EffectScore>& scores, const Progress& progress) {
    std::atomic<int> done{0};
    std::mutex mutex;
    Throttle throttle;
    const auto trials = data.trials.size();
    const int runs = static_cast<int>(columns.size() * trials);
    parallel_tasks(runs, setup.settings.threads, [&](int task) {
        if (progress.cancelled()) return;
        ProbeColumn& column = columns[static_cast<std::size_t>(task) / trials];
        const std::size_t i = static_cast<std::size_t>(task) % trials;
        const Stopwatch watch;
        column.predictions[i] = probed(setup, data.trials[i], search.trials[i], column.values, unaffected[i], progress);
        column.predictions[i].trace = {};
        const std::lock_guard<std::mutex> lock(mutex);
        scores[column.probe].seconds += watch.seconds();
        if (++done == runs || throttle.ready())
            progress.report({"score", static_cast<double>(done), static_cast<double>(runs), "runs",
                             column.values.effects.back().id});
    });
}

/// Changes of the residual by the probes, N x columns each. Probes of which a run failed get the reason in their score.
std::vector<MatrixXd> responses(const FitData& data, const std::vector<Probe>& probes,
                                const std::vector<ProbeColumn>& columns, const VectorXd& before,
                                std::vector<EffectScore>& scores) {
    std::vector<MatrixXd> S;
    for (const Probe& probe : probes)
        S.emplace_back(data.layout.size(), static_cast<Index>(probe.probe.columns.size()));
    for (const ProbeColumn& column : columns) {
        EffectScore& score = scores[column.probe];
        for (const prediction::TrialPrediction& prediction : column.predictions)
            if (!prediction.ok()) score.failure = prediction.message;
        if (score.failure.empty())
            S[column.probe].col(column.number) = flat_residual(data, column.predictions) - before;
    }
    return S;
}

}  // namespace

effect::EffectSearch effect_search(const setup::Setup& setup, const FitData& data,
                                   const prediction::ParameterValues& values) {
    effect::EffectSearch search;
    for (const std::size_t trial : data.trials) {
        search.trials.push_back(setup::trial_context(setup, trial));
        search.models.push_back(prediction::trial_model(setup, trial, values));
    }
    for (const prediction::ModelParameter& parameter : prediction::free_parameters(setup))
        search.damping_is_fitted = search.damping_is_fitted ||
                                   parameter.kind == prediction::ModelParameter::Kind::damping;
    return search;
}

std::vector<EffectScore> score_effects(const setup::Setup& setup, const FitData& data, const JointFit& fit,
                                       const std::vector<prediction::TrialPrediction>& unaffected,
                                       const EffectFilter& allowed, ProbeSize size, const ScreeningPolicy& policy,
                                       const Progress& progress) {
    effect::EffectSearch search = effect_search(setup, data, fit.values);
    search.largest_energy_density_J_m3 = peak_isochoric_energy(search.models, unaffected);
    search.residual_lines_Hz = residual_lines(flat_residual(data, unaffected), data.layout, policy.residual_lines);
    const std::vector<Probe> probes = chosen_probes(search, allowed, size);
    std::vector<ProbeColumn> columns = columns_of(probes, fit.values, data.trials.size());
    std::vector<EffectScore> scores(probes.size());
    for (std::size_t p = 0; p < probes.size(); ++p) scores[p].id = probes[p].effect->id;
    run_columns(setup, data, search, unaffected, columns, scores, progress);
    if (progress.cancelled()) return {};

    const ScoreReference reference = score_reference(fit, data.layout);
    const std::vector<MatrixXd> S = responses(data, probes, columns, flat_residual(data, unaffected), scores);
    parallel_tasks(static_cast<int>(probes.size()), setup.settings.threads, [&](int task) {
        const auto p = static_cast<std::size_t>(task);
        if (!scores[p].failure.empty()) return;
        const double seconds = scores[p].seconds;
        scores[p] = score_probe(*probes[p].effect, probes[p].probe, S[p], reference, policy);
        scores[p].seconds = seconds;
    });
    if (size == ProbeSize::large) return scores;
    for (EffectScore& score : scan_markers(setup, data, fit, reference.nuisance, allowed, policy)) {
        if (score.usable()) score.left = (1.0 - score.test.explained) * reference.squares;
        scores.push_back(std::move(score));
    }
    return scores;
}

}  // namespace myo::diagnosis
