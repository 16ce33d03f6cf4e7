#include "diagnosis/screening/effect_scores.hpp"

#include <utility>

#include "base/parallel.hpp"
#include "diagnosis/missing_force/peak_energy.hpp"
#include "diagnosis/screening/effect_responses.hpp"
#include "diagnosis/screening/marker_scan.hpp"
#include "diagnosis/screening/probe_score.hpp"
#include "diagnosis/screening/residual_lines.hpp"
#include "effect/catalogue.hpp"

namespace myo::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Probe with the effect that it belongs to.
struct Probe {
    const effect::Effect* effect = nullptr;
    effect::LawPointer law;  // null: the effect is in the catalogue
    effect::EffectProbe probe;
};

/// Probes of the given size of all allowed effects.
std::vector<Probe> chosen_probes(const effect::EffectSearch& search, const effect::Laws& laws,
                                 const EffectFilter& allowed, ProbeSize size) {
    std::vector<Probe> probes;
    for (const effect::Effect* const effect : effect::all_effects(laws)) {
        if (!effect->probes || !allowed(effect->id)) continue;
        for (effect::EffectProbe& probe : effect->probes(search))
            if (probe.large == (size == ProbeSize::large))
                probes.push_back({effect, effect::find_law(effect->id, laws), std::move(probe)});
    }
    return probes;
}

/// The columns of all probes, one after the other.
std::vector<effect::EffectDeclaration> columns_of(const std::vector<Probe>& probes) {
    std::vector<effect::EffectDeclaration> columns;
    for (const Probe& probe : probes)
        for (const effect::EffectParameters& column : probe.probe.columns)
            columns.push_back({probe.effect->id, column, false, probe.law});
    return columns;
}

/// Changes of the residual by the probes, N x columns each. Probes of which a run failed get the reason in their score.
std::vector<MatrixXd> changes_by(const std::vector<Probe>& probes, const std::vector<EffectResponse>& responses,
                                 Index rows, std::vector<EffectScore>& scores) {
    std::vector<MatrixXd> S;
    std::size_t next = 0;
    for (std::size_t p = 0; p < probes.size(); ++p) {
        S.emplace_back(rows, static_cast<Index>(probes[p].probe.columns.size()));
        for (Index c = 0; c < S.back().cols(); ++c, ++next) {
            const EffectResponse& response = responses[next];
            scores[p].seconds += response.seconds;
            if (!response.failure.empty())
                scores[p].failure = response.failure;
            else
                S.back().col(c) = response.change;
        }
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
    // Amounts of some probes follow from the motion of the fit (strains) or from its residual (frequencies).
    search.largest_energy_density_J_m3 = peak_isochoric_energy(search.models, unaffected);
    search.residual_lines_Hz = residual_lines(flat_residual(data, unaffected), data.layout, policy.residual_lines);
    const std::vector<Probe> probes = chosen_probes(search, setup.experiment.laws, allowed, size);
    std::vector<EffectScore> scores(probes.size());
    for (std::size_t p = 0; p < probes.size(); ++p) scores[p].id = probes[p].effect->id;
    // Small probes stand for derivatives; large ones are tried for what those do not show.
    const std::vector<EffectResponse> responses = effect_responses(
        {setup, data, fit.values, search, unaffected}, columns_of(probes),
        size == ProbeSize::small ? std::optional(policy.first_order) : std::nullopt, "score", progress);
    if (progress.cancelled()) return {};

    const ScoreReference reference = score_reference(fit, data.layout);
    const std::vector<MatrixXd> S = changes_by(probes, responses, data.layout.size(), scores);
    parallel_tasks(static_cast<int>(probes.size()), setup.settings.threads, [&](int task) {
        const auto p = static_cast<std::size_t>(task);
        if (!scores[p].failure.empty()) return;
        // score_probe() makes a new score; the time of its runs was entered before.
        const double seconds = scores[p].seconds;
        scores[p] = score_probe(*probes[p].effect, probes[p].probe, S[p], reference, policy);
        scores[p].seconds = seconds;
        scores[p].law = probes[p].law;
    });
    // Events of markers are linear in the residual and need no large probes.
    if (size == ProbeSize::large) return scores;
    for (EffectScore& score : scan_markers(setup, data, fit, reference.nuisance, allowed, policy)) {
        if (score.usable()) score.left = (1.0 - score.test.explained) * reference.squares;
        scores.push_back(std::move(score));
    }
    return scores;
}

}  // namespace myo::diagnosis
