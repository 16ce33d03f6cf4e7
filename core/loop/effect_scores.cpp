#include "loop/effect_scores.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "base/throttle.hpp"
#include "effect/catalogue.hpp"
#include "loop/marker_scan.hpp"
#include "loop/peak_energy.hpp"
#include "project/predict_trials.hpp"

namespace myo {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A column of a probe with its difference to the fit.
struct Column {
    std::size_t score = 0;
    Index number = 0;
    StudyValues values;
    std::vector<TrialPrediction> predictions;   // per trial of the data
    std::string failure;
};

struct Probe {
    const Effect* effect = nullptr;
    EffectProbe probe;
};

double amount_of(const EffectProbe& probe) { return number(probe.columns.front(), probe.amount); }

/// Parameters of a probe of one number whose effect is `multiple` times as large; false: absent, or beyond its bounds' sign.
bool scaled(const Effect& effect, const EffectProbe& probe, double multiple, EffectParameters& result) {
    const EffectParameterEntry& entry = *effect.parameter(probe.amount);
    result = probe.columns.front();
    const double value = probe.reciprocal ? amount_of(probe) / multiple : amount_of(probe) * multiple;
    if (!std::isfinite(value) || value == 0.0) return false;
    if (entry.lowest >= 0.0 && value <= 0.0) return false;
    result[probe.amount] = std::clamp(value, entry.lowest, entry.highest);
    return true;
}

void finish(const Probe& probe, const NuisanceSpace& nuisance, const VectorXd& outside, const FitData& data, const MatrixXd& S, EffectScore& score) {
    score.candidate = project_candidate(nuisance, S);
    score.test = score_test(score.candidate, outside, data.layout);
    if (score.candidate.rank() == 0) return;
    // The residual is prediction less measurement, so what has to be added to the prediction is minus the step of the test.
    const VectorXd multiples = -score.test.step;
    const bool possible = probe.probe.joined ? multiples.allFinite() : scaled(*probe.effect, probe.probe, multiples(0), score.start);
    if (possible && probe.probe.joined) score.start = probe.probe.joined(probe.probe.columns, multiples);
    if (!possible) score.test.explained = 0.0;
    score.predicted = score.candidate.basis * (score.candidate.basis.transpose() * outside);
}

}  // namespace

EffectSearch effect_search(const Study& study, const FitData& data, const StudyValues& values) {
    EffectSearch search;
    for (const std::size_t trial : data.trials) {
        search.sites.push_back(effect_site(study, trial));
        search.models.push_back(trial_model(study, trial, values));
    }
    for (const StudyParameter& parameter : study_parameters(study))
        search.damping_is_fitted = search.damping_is_fitted || parameter.kind == StudyParameter::Kind::damping;
    return search;
}

std::vector<EffectScore> score_effects(const Study& study, const FitData& data, const JointFit& fit, const EffectFilter& allowed, const Progress& progress) {
    EffectSearch search = effect_search(study, data, fit.values);
    search.largest_energy_density_J_m3 = peak_isochoric_energy(search.models, fit.predictions);
    std::vector<Probe> probes;
    std::vector<EffectScore> scores;
    std::vector<Column> columns;
    for (const Effect& effect : effect_catalogue()) {
        if (!effect.probes || !allowed(effect.id)) continue;
        for (EffectProbe& probe : effect.probes(search)) {
            for (std::size_t c = 0; c < probe.columns.size(); ++c) {
                Column column{probes.size(), static_cast<Index>(c), fit.values, std::vector<TrialPrediction>(data.trials.size()), {}};
                column.values.effects.push_back({effect.id, probe.columns[c]});
                columns.push_back(std::move(column));
            }
            scores.emplace_back();
            scores.back().id = effect.id;
            probes.push_back({&effect, std::move(probe)});
        }
    }

    std::atomic<int> done{0};
    std::mutex mutex;
    Throttle throttle;
    const auto trials = data.trials.size();
    const int runs = static_cast<int>(columns.size() * trials);
    parallel_tasks(runs, study.settings.threads, [&](int task) {
        if (progress.cancelled()) return;
        Column& column = columns[static_cast<std::size_t>(task) / trials];
        const std::size_t i = static_cast<std::size_t>(task) % trials, trial = data.trials[i];
        const EffectDeclaration& effect = column.values.effects.back();
        const Stopwatch watch;
        if (!acts_on(search.sites[i], effect.parameters)) column.predictions[i] = fit.predictions[i];
        else if (is_seen_only(effect)) column.predictions[i] = observe_trial(study, trial, column.values, fit.predictions[i].trace);
        else column.predictions[i] = predict_trial(study, trial, column.values, {}, progress.with_sink({}));
        column.predictions[i].trace = {};
        const std::lock_guard<std::mutex> lock(mutex);
        scores[column.score].seconds += watch.seconds();
        if (++done == runs || throttle.ready()) progress.report({"score", static_cast<double>(done), static_cast<double>(runs), "runs", effect.id});
    });
    if (progress.cancelled()) return {};

    const NuisanceSpace nuisance(fit.jacobian);
    const VectorXd outside = nuisance.outside(fit.residual);
    std::vector<MatrixXd> S(probes.size());
    for (std::size_t p = 0; p < probes.size(); ++p) S[p].resize(data.layout.size(), static_cast<Index>(probes[p].probe.columns.size()));
    for (const Column& column : columns) {
        for (const TrialPrediction& prediction : column.predictions)
            if (!prediction.ok()) scores[column.score].failure = prediction.message;
        if (scores[column.score].failure.empty()) S[column.score].col(column.number) = flat_residual(data, column.predictions) - fit.residual;
    }
    parallel_tasks(static_cast<int>(probes.size()), study.settings.threads, [&](int task) {
        const auto p = static_cast<std::size_t>(task);
        if (scores[p].failure.empty()) finish(probes[p], nuisance, outside, data, S[p], scores[p]);
    });
    for (EffectScore& score : scan_markers(study, data, fit, nuisance, allowed)) scores.push_back(std::move(score));
    return scores;
}

}  // namespace myo
