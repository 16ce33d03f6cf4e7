#include "diagnosis/verdict/verdict.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "diagnosis/selection/judgement.hpp"
#include "diagnosis/verdict/verdict_rules.hpp"

namespace myo::diagnosis {
namespace {

/// Ranking: effects or kind of the verdict, then the other candidates, most credible first, then `unknown` and `none`.
void rank(Diagnosis& d) {
    std::vector<std::string>& ranking = d.verdict.ranking;
    for (const effect::EffectDeclaration& effect : d.verdict.effects) ranking.push_back(effect.id);
    if (d.verdict.kind == VerdictKind::none) ranking.push_back("none");
    if (d.verdict.kind == VerdictKind::unknown) ranking.push_back("unknown");
    for (const Candidate& candidate : d.candidates)
        if (std::find(ranking.begin(), ranking.end(), candidate.score.id) == ranking.end())
            ranking.push_back(candidate.score.id);
    for (const char* last : {"unknown", "none"})
        if (std::find(ranking.begin(), ranking.end(), last) == ranking.end()) ranking.push_back(last);
}

}  // namespace

std::string above_noise_note(const NumericalError& numerics, double noise_m) {
    const bool by_mesh = numerics.mesh_rms_m >= numerics.step_rms_m;
    return "the uncertainty of the errors of mesh and step, " + times_noise(numerics.left_rms_m / noise_m) +
           ", is above the noise (mesh " + times_noise(numerics.mesh_rms_m / noise_m) + ", step " +
           times_noise(numerics.step_rms_m / noise_m) + "): choose a " +
           (by_mesh ? "finer --resolution" : "smaller --dt") + " before trusting small effects";
}

JudgedFit decide(Diagnosis& d) {
    const VerdictEvidence evidence = verdict_evidence(d);
    const std::vector<VerdictRule>& rules = verdict_rules();
    const auto rule = std::find_if(rules.begin(), rules.end(),
                                   [&](const VerdictRule& r) { return r.applies(evidence); });
    Conclusion conclusion = rule->conclude(evidence);
    d.verdict = std::move(conclusion.verdict);
    d.verdict.rule = rule->name;
    if (d.verdict.kind == VerdictKind::unknown && !d.pairs.empty() && is_untested(d.pairs.front(), d.declared) &&
        explains(d.pairs.front(), d.declared, d.data, d.numerics, d.settings.policy.judgement))
        d.notes.push_back(effects_in_words(d.pairs.front().fit.effects) +
                          " together would explain it, but one of their numbers rests on a single trial: a further "
                          "fit trial would decide");
    if (d.numerics.left_rms_m > d.noise_m) d.notes.push_back(above_noise_note(d.numerics, d.noise_m));
    rank(d);
    return std::move(conclusion.fit);
}

void take_over_corrected(Diagnosis& d) {
    if (d.verdict.kind != VerdictKind::effects) return;
    d.verdict.effects = d.augmented.fit.effects;
    d.verdict.because = systematic_fall(d.augmented, d.declared) + d.verdict.but;
    const auto same = [&](const JudgedFit& fit) {
        return fit.fit.effects.size() == d.verdict.effects.size() &&
               std::equal(
                   fit.fit.effects.begin(), fit.fit.effects.end(), d.verdict.effects.begin(),
                   [](const effect::EffectDeclaration& a, const effect::EffectDeclaration& b) { return a.id == b.id; });
    };
    const auto take_over = [&](JudgedFit& fit) {
        const double weight = fit.weight;  // of the selection
        fit = d.augmented;
        fit.weight = weight;
    };
    for (Candidate& candidate : d.candidates)
        if (candidate.judged && same(*candidate.judged)) take_over(*candidate.judged);
    for (JudgedFit& pair : d.pairs)
        if (same(pair)) take_over(pair);
}

void discount_worse_predictions(Diagnosis& d) {
    const VerdictPolicy& policy = d.settings.policy.verdict;
    const double before = d.before.validation_rms_m, after = d.after.validation_rms_m;
    if (d.verdict.kind != VerdictKind::effects || !(after > policy.worse_prediction * before) ||
        !(after > policy.good_prediction * d.noise_m))
        return;
    d.verdict.confidence *= policy.contradicted;
    d.notes.push_back("trials that took no part are predicted worse with " + effects_in_words(d.verdict.effects) +
                      ", " + times_noise(after / d.noise_m) + " instead of " + times_noise(before / d.noise_m) +
                      ": do not rely on this answer; another effect may be missing, or it may differ in these trials");
}

}  // namespace myo::diagnosis
