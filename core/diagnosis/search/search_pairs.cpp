#include "diagnosis/search/search_pairs.hpp"

#include "diagnosis/diagnosis_policy.hpp"
#include "diagnosis/screening/candidate_scores.hpp"
#include "diagnosis/search/search_effects.hpp"
#include "diagnosis/selection/judgement.hpp"
#include "prediction/predict_trials.hpp"

namespace myo::diagnosis {
namespace {

/// Refits one effect of a pair alone, from its values in the pair: its earlier fit may have ended in a local minimum.
void try_alone(DiagnosisWork& work, const JudgedFit& pair, std::size_t kept) {
    if (work.progress.cancelled() || explained(work.result)) return;
    prediction::ParameterValues values = pair.fit.values;
    values.effects.erase(values.effects.begin() +
                         static_cast<std::ptrdiff_t>(work.setup.experiment.effects.size() + 1 - kept));
    JointFit alone = work.fit("refit of pairs", values, diagnosis_policy.search.polish);
    if (work.progress.cancelled() || !alone.usable()) return;
    const std::string id = pair.fit.effects[kept].id;
    for (Candidate& candidate : work.result.candidates)
        if (candidate.score.id == id && alone.squares() < left_by(work.result, id)) {
            candidate.judged = judged(work.result.data, std::move(alone), work.result.settings);
            break;
        }
    order_candidates(work.result);
}

}  // namespace

void search_pairs(DiagnosisWork& work) {
    Diagnosis& result = work.result;
    if (result.candidates.empty() || !result.candidates.front().judged) return;
    const JudgedFit& first = *result.candidates.front().judged;
    if (explains(first, result.declared, result.data, result.numerics, result.settings.policy.judgement) ||
        first.fit.excess() > diagnosis_policy.pairs.most_left * result.declared.fit.excess())
        return;
    JointFit base = first.fit;
    if (first.numerics) result.data.shift = first.numerics->shift;
    base.predictions = prediction::predict_trials_with(work.setup, base.values, result.data.trials, work.progress);
    if (work.progress.cancelled()) return;
    const std::string first_id = result.candidates.front().score.id;
    const std::vector<EffectScore> scores = work.stage("score of pairs", 0, [&] {
        return score_with_longer_steps(
            work.setup, result.data, base, [&](const std::string& id) { return id != first_id && work.allowed(id); },
            ProbeSize::small, work.progress);
    });
    if (work.progress.cancelled()) return;
    std::vector<CandidateStart> starts;
    for (const std::size_t i : best_probes(scores, result.settings.pairs)) starts.push_back(start_of(scores[i]));
    std::vector<JudgedFit> fits = work.fit_all("refit of pairs", base, starts, least_left(result),
                                               diagnosis_policy.pairs.pruning_factor);
    if (work.progress.cancelled()) return;
    for (JudgedFit& fit : fits)
        if (fit.usable()) result.pairs.push_back(std::move(fit));
    order_pairs(result);
    if (!result.pairs.empty())
        for (const std::size_t kept : {1u, 0u}) try_alone(work, result.pairs.front(), kept);
    order_pairs(result);
    work.show();
}

}  // namespace myo::diagnosis
