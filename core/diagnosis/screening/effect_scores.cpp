#include "diagnosis/screening/effect_scores.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "base/throttle.hpp"
#include "diagnosis/diagnosis_policy.hpp"
#include "diagnosis/missing_force/peak_energy.hpp"
#include "diagnosis/screening/marker_scan.hpp"
#include "effect/catalogue.hpp"
#include "inverse/bounded_step.hpp"
#include "prediction/predict_trials.hpp"

namespace myo::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// One column of a probe with its predictions.
struct ProbeColumn {
    std::size_t score = 0;
    Index number = 0;
    prediction::ParameterValues values;
    std::vector<prediction::TrialPrediction> predictions;  // per trial of the data
    std::string failure;
};

struct Probe {
    const effect::Effect* effect = nullptr;
    effect::EffectProbe probe;
};

double amount_of(const effect::EffectProbe& probe) { return effect::number(probe.columns.front(), probe.amount); }

/// Parameters of a single-column probe with `multiple` times the effect. Returns false if the amount would be zero, not
/// finite, or of a sign that its bounds exclude.
bool scaled(const effect::Effect& effect, const effect::EffectProbe& probe, double multiple,
            effect::EffectParameters& result) {
    const effect::EffectParameterEntry& entry = *effect.parameter(probe.amount);
    result = probe.columns.front();
    const double value = probe.reciprocal ? amount_of(probe) / multiple : amount_of(probe) * multiple;
    if (!std::isfinite(value) || value == 0.0) return false;
    if (entry.lowest >= 0.0 && value <= 0.0) return false;
    result[probe.amount] = std::clamp(value, entry.lowest, entry.highest);
    return true;
}

/// Range of the multiple of a probe that keeps its amount within bounds. Negative multiples are admitted only for
/// joined columns and for amounts that may be negative.
struct Range {
    double lowest = -std::numeric_limits<double>::infinity(), highest = std::numeric_limits<double>::infinity();
};
Range multiples_of(const Probe& probe) {
    if (probe.probe.amount.empty()) return {};
    const effect::EffectParameterEntry& entry = *probe.effect->parameter(probe.probe.amount);
    const double amount = amount_of(probe.probe);
    if (probe.probe.joined) return {-entry.highest / std::abs(amount), entry.highest / std::abs(amount)};
    if (entry.lowest < 0.0) return {entry.lowest / std::abs(amount), entry.highest / std::abs(amount)};
    return {0.0, probe.probe.reciprocal ? amount / entry.lowest : entry.highest / amount};
}

/// Admissible steps of the fit's own parameters, and the squared residual after their best step.
struct OwnSteps {
    VectorXd lower, upper;
    double squares = 0.0;
};
OwnSteps own_steps(const JointFit& fit) {
    OwnSteps own{VectorXd(fit.jacobian.cols()), VectorXd(fit.jacobian.cols())};
    for (Index i = 0; i < fit.jacobian.cols(); ++i) {
        const prediction::ModelParameter& p = fit.parameters[static_cast<std::size_t>(i)];
        const double value = prediction::value_of(p, fit.values);
        own.lower(i) = std::min(0.0, p.parameter.lower - value);
        own.upper(i) = std::max(0.0, p.parameter.upper - value);
    }
    own.squares = (fit.residual +
                   fit.jacobian * inverse::bounded_step(fit.jacobian, fit.residual, own.lower, own.upper))
                      .squaredNorm();
    return own;
}

/// Starts of a nonlinear probe: the amount that changes the residual by its own norm and, if distinct, the amount of
/// the probe, each with the step of the fit's parameters that best compensates it.
std::vector<EffectScore::Start> starts_away(const Probe& probe, const JointFit& fit, const OwnSteps& own,
                                            const VectorXd& S, const Range& range) {
    const double modest = std::clamp(fit.residual.norm() / std::max(S.norm(), std::numeric_limits<double>::min()),
                                     range.lowest, range.highest);
    std::vector<EffectScore::Start> starts;
    for (const double multiple : {modest, 1.0}) {
        if (!starts.empty() && modest < diagnosis_policy.screening.distinct_start &&
            modest > 1.0 / diagnosis_policy.screening.distinct_start)
            break;
        EffectScore::Start start;
        if (!scaled(*probe.effect, probe.probe, multiple, start.effect)) continue;
        start.step = inverse::bounded_step(fit.jacobian, VectorXd(multiple * S), own.lower, own.upper);
        starts.push_back(std::move(start));
    }
    return starts;
}

/// A with one damping row for each of its last columns, those of a probe of several: a direction that is hardly
/// observable (along a thin plate) must not dominate the result.
MatrixXd with_damped_columns(const MatrixXd& A, const MatrixXd& S) {
    if (S.cols() < 2) return A;
    MatrixXd damped = MatrixXd::Zero(A.rows() + S.cols(), A.cols());
    damped.topRows(A.rows()) = A;
    damped.bottomRightCorner(S.cols(), S.cols())
        .diagonal()
        .setConstant(diagnosis_policy.screening.negligible_column * S.colwise().norm().maxCoeff());
    return damped;
}

/// Scores a probe. The fit's parameters and the candidate together take the best step within their bounds: a modulus at
/// the limit of its tolerance must not replace the missing effect.
void finish(const Probe& probe, const statistics::NuisanceSpace& nuisance, const VectorXd& outside, const FitData& data,
            const JointFit& fit, const OwnSteps& own, const MatrixXd& S, EffectScore& score) {
    score.candidate = statistics::project_candidate(nuisance, S);
    score.test = statistics::score_test(score.candidate, outside, data.layout);
    if (score.candidate.rank() == 0) return;
    if (!probe.probe.joined) score.probed = probe.probe.columns.front();
    MatrixXd A(S.rows(), fit.jacobian.cols() + S.cols());
    A << fit.jacobian, S;
    const MatrixXd damped = with_damped_columns(A, S);
    const Range range = multiples_of(probe);
    VectorXd lower(A.cols()), upper(A.cols());
    lower.head(own.lower.size()) = own.lower;
    upper.head(own.upper.size()) = own.upper;
    for (Index c = 0; c < S.cols(); ++c) {
        const double tiny = std::numeric_limits<double>::min();
        const double most = fit.residual.norm() *
                            std::min(diagnosis_policy.screening.most_over_residual / std::max(S.col(c).norm(), tiny),
                                     diagnosis_policy.screening.most_outside /
                                         std::max(nuisance.outside(S.col(c)).norm(), tiny));
        lower(own.lower.size() + c) = std::max(range.lowest, -most);
        upper(own.upper.size() + c) = std::min(range.highest, most);
    }
    VectorXd residual = VectorXd::Zero(damped.rows());
    residual.head(A.rows()) = fit.residual;
    const VectorXd step = inverse::bounded_step(damped, residual, lower, upper), multiples = step.tail(S.cols());
    score.best.step = step.head(own.lower.size());
    const double squares = (fit.residual + A * step).squaredNorm();
    const bool possible = probe.probe.joined ? multiples.allFinite()
                                             : scaled(*probe.effect, probe.probe, multiples(0), score.best.effect);
    if (possible && probe.probe.joined) score.best.effect = probe.probe.joined(probe.probe.columns, multiples);
    score.test.explained = possible && own.squares > 0.0 ? std::max(0.0, 1.0 - squares / own.squares) : 0.0;
    score.left = (1.0 - score.test.explained) * own.squares;
    if (!probe.probe.joined && S.col(0).norm() > diagnosis_policy.screening.nonlinear_ratio * fit.residual.norm())
        score.nonlinear = starts_away(probe, fit, own, S.col(0), range);
    score.predicted = score.candidate.basis * (score.candidate.basis.transpose() * outside);
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
                                       const EffectFilter& allowed, ProbeSize size, const Progress& progress) {
    effect::EffectSearch search = effect_search(setup, data, fit.values);
    search.largest_energy_density_J_m3 = peak_isochoric_energy(search.models, unaffected);
    std::vector<Probe> probes;
    std::vector<EffectScore> scores;
    std::vector<ProbeColumn> columns;
    for (const effect::Effect& effect : effect::effect_catalogue()) {
        if (!effect.probes || !allowed(effect.id)) continue;
        for (effect::EffectProbe& probe : effect.probes(search)) {
            if (probe.large != (size == ProbeSize::large)) continue;
            for (std::size_t c = 0; c < probe.columns.size(); ++c) {
                ProbeColumn column{probes.size(),
                                   static_cast<Index>(c),
                                   fit.values,
                                   std::vector<prediction::TrialPrediction>(data.trials.size()),
                                   {}};
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
    parallel_tasks(runs, setup.settings.threads, [&](int task) {
        if (progress.cancelled()) return;
        ProbeColumn& column = columns[static_cast<std::size_t>(task) / trials];
        const std::size_t i = static_cast<std::size_t>(task) % trials, trial = data.trials[i];
        const effect::EffectDeclaration& effect = column.values.effects.back();
        const Stopwatch watch;
        if (!effect::acts_on(search.trials[i], effect.parameters))
            column.predictions[i] = unaffected[i];
        else if (setup::changes_observation_only(effect))
            column.predictions[i] = prediction::observe_trial(setup, trial, column.values, unaffected[i].trace);
        else
            column.predictions[i] = prediction::predict_trial(setup, trial, column.values, {}, progress.with_sink({}),
                                                              unaffected[i].trace.path);
        column.predictions[i].trace = {};
        const std::lock_guard<std::mutex> lock(mutex);
        scores[column.score].seconds += watch.seconds();
        if (++done == runs || throttle.ready())
            progress.report({"score", static_cast<double>(done), static_cast<double>(runs), "runs", effect.id});
    });
    if (progress.cancelled()) return {};

    const statistics::NuisanceSpace nuisance(fit.jacobian);
    const VectorXd outside = nuisance.outside(fit.residual);
    const OwnSteps own = own_steps(fit);
    const VectorXd before = flat_residual(data, unaffected);
    std::vector<MatrixXd> S(probes.size());
    for (std::size_t p = 0; p < probes.size(); ++p)
        S[p].resize(data.layout.size(), static_cast<Index>(probes[p].probe.columns.size()));
    for (const ProbeColumn& column : columns) {
        for (const prediction::TrialPrediction& prediction : column.predictions)
            if (!prediction.ok()) scores[column.score].failure = prediction.message;
        if (scores[column.score].failure.empty())
            S[column.score].col(column.number) = flat_residual(data, column.predictions) - before;
    }
    parallel_tasks(static_cast<int>(probes.size()), setup.settings.threads, [&](int task) {
        const auto p = static_cast<std::size_t>(task);
        if (scores[p].failure.empty()) finish(probes[p], nuisance, outside, data, fit, own, S[p], scores[p]);
    });
    if (size == ProbeSize::large) return scores;
    for (EffectScore& score : scan_markers(setup, data, fit, nuisance, allowed)) {
        if (score.usable()) score.left = (1.0 - score.test.explained) * own.squares;
        scores.push_back(std::move(score));
    }
    return scores;
}

}  // namespace myo::diagnosis
