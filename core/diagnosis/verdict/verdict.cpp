#include "diagnosis/verdict/verdict.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.hpp"
#include "diagnosis/selection/judgement.hpp"
#include "diagnosis/verdict/verdict_rules.hpp"

namespace myo::diagnosis {
namespace {

/// Ranking: effects or kind of the verdict, then the other candidates, most credible first, then `unknown` and `none`.
std::vector<std::string> ranking_of(const Verdict& verdict, const std::vector<Candidate>& candidates) {
    std::vector<std::string> ranking;
    for (const effect::EffectDeclaration& effect : verdict.effects) ranking.push_back(effect.id);
    if (verdict.kind == VerdictKind::none) ranking.push_back("none");
    if (verdict.kind == VerdictKind::unknown) ranking.push_back("unknown");
    for (const Candidate& candidate : candidates)
        if (std::find(ranking.begin(), ranking.end(), candidate.score.id) == ranking.end())
            ranking.push_back(candidate.score.id);
    for (const char* last : {"unknown", "none"})
        if (std::find(ranking.begin(), ranking.end(), last) == ranking.end()) ranking.push_back(last);
    return ranking;
}

/// Verdict of a search that ended at its limit of time: less certain, and it says so.
Verdict of_unfinished_search(Verdict verdict, const DiagnoseSettings& settings) {
    verdict.confidence *= settings.policy.verdict.unfinished_search;
    verdict.trust *= settings.policy.verdict.unfinished_search;
    const std::string caution = " The search ended at its limit of " + format_number(*settings.search_limit_s, 4) +
                                " s: what was not tried may explain more.";
    verdict.reason += caution;
    verdict.cautions += caution;
    return verdict;
}

}  // namespace

std::string above_noise_note(const NumericalError& numerics, double noise_m) {
    const bool by_mesh = numerics.mesh_rms_m >= numerics.step_rms_m;
    return "the uncertainty of the errors of mesh and step, " + times_noise(numerics.left_rms_m / noise_m) +
           ", is above the noise (mesh " + times_noise(numerics.mesh_rms_m / noise_m) + ", step " +
           times_noise(numerics.step_rms_m / noise_m) + "): choose a " +
           (by_mesh ? "finer --resolution" : "smaller --dt") + " before trusting small effects";
}

Decision decide(const Diagnosis& d) {
    const VerdictEvidence evidence = verdict_evidence(d);
    const std::vector<VerdictRule>& rules = verdict_rules();
    // The last rule always applies, so that one is found.
    const auto rule = std::find_if(rules.begin(), rules.end(),
                                   [&](const VerdictRule& r) { return r.applies(evidence); });
    Conclusion conclusion = rule->conclude(evidence);
    Decision decision{std::move(conclusion.verdict), std::move(conclusion.fit), {}};
    Verdict& verdict = decision.verdict;
    verdict.rule = rule->name;
    if (!d.search_complete) verdict = of_unfinished_search(std::move(verdict), d.settings);
    verdict.ranking = ranking_of(verdict, d.candidates);
    // verdict_evidence() leaves such a set out: the user can decide the case with one more trial.
    if (verdict.kind == VerdictKind::unknown && !d.sets.empty() && is_untested(d.sets.front(), d.declared) &&
        explains(d.sets.front(), d.baseline()))
        decision.notes.push_back(
            effects_in_words(d.sets.front().fit.effects) +
            " together would explain it, but one of their numbers rests on a single trial: a further "
            "fit trial would decide");
    if (d.numerics.left_rms_m > d.noise_m) decision.notes.push_back(above_noise_note(d.numerics, d.noise_m));
    return decision;
}

Diagnosis with_final_fit(Diagnosis d) {
    if (d.verdict.kind != VerdictKind::effects) return d;
    d.verdict.effects = d.augmented.fit.effects;
    d.verdict.reason = systematic_fall(d.augmented, d.declared) + d.verdict.cautions;
    // The tables of the report show candidates and sets: the verdict's own fit must have one value everywhere.
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
    for (JudgedFit& set : d.sets)
        if (same(set)) take_over(set);
    return d;
}

Diagnosis with_tested_confidence(Diagnosis d) {
    const VerdictPolicy& policy = d.settings.policy.verdict;
    const double before = d.before.validation_rms_m, after = d.after.validation_rms_m;
    if (d.verdict.kind != VerdictKind::effects || !(after > policy.worse_prediction * before) ||
        !(after > policy.good_prediction * d.noise_m))
        return d;
    d.verdict.confidence *= policy.contradicted;
    d.verdict.trust *= policy.contradicted;
    d.notes.push_back("trials that took no part are predicted worse with " + effects_in_words(d.verdict.effects) +
                      ", " + times_noise(after / d.noise_m) + " instead of " + times_noise(before / d.noise_m) +
                      ": do not rely on this answer; another effect may be missing, or it may differ in these trials");
    return d;
}

}  // namespace myo::diagnosis
