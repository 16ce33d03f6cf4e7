#include "diagnosis/verdict/verdict_rules.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/text.hpp"
#include "diagnosis/report/effect_words.hpp"
#include "diagnosis/selection/ranking.hpp"
#include "diagnosis/verdict/probabilities.hpp"

namespace myo::diagnosis {
namespace {

/// Verdict `none`; its confidence falls with the systematic residual over the numerical allowance.
Conclusion nothing_missing(const VerdictEvidence& e) {
    const Diagnosis& d = e.diagnosis;
    const VerdictPolicy& policy = e.policy.verdict;
    const double share = d.declared.tests.systematic.rms / numerical_allowance(d.data, d.numerics, e.policy.judgement);
    Verdict verdict{VerdictKind::none};
    verdict.confidence = policy.undoubted * (d.declared.tests.significant()
                                                 ? std::clamp(policy.faint_allowance - share, policy.min_faint, 1.0)
                                                 : 1.0);
    verdict.reason = "the residual of the declared model is " + times_noise(d.declared.rms_m / d.noise_m) +
                     ", of which " + times_noise(d.declared.tests.systematic.rms) + " is systematic: " +
                     (share > 1.0 ? "little, and no effect takes most of it away."
                                  : "no more than the numerical error may be.");
    return {verdict, d.declared};
}

/// Residual that is uncorrelated between markers: no force on a body causes that.
Conclusion drift(const VerdictEvidence& e) {
    const Diagnosis& d = e.diagnosis;
    Verdict verdict{VerdictKind::none};
    verdict.confidence = e.policy.verdict.undoubted * e.policy.verdict.drift;
    verdict.reason =
        "the residual of the declared model is " + times_noise(d.declared.rms_m / d.noise_m) + ", of which " +
        times_noise(d.declared.tests.systematic.rms) +
        " is not white noise, but uncorrelated between markers: no force on the body does that. It is attributed to "
        "measurement drift.";
    return {verdict, d.declared};
}

/// Appends a sentence to the reason; kept separately, so that a later reason can repeat it.
void add_caution(Verdict& verdict, const std::string& sentence) {
    verdict.cautions += " " + sentence;
    verdict.reason += " " + sentence;
}

/// Verdict that names the effects of a fit.
/// @param weight  factor of the confidence: evidence for these effects among all fits, 0 ... 1
Conclusion named(const VerdictEvidence& e, const JudgedFit& fit, double weight) {
    const VerdictPolicy& policy = e.policy.verdict;
    const bool effect_bound = effect_at_bound(fit.fit, e.policy.judgement),
               modulus_bound = modulus_at_bound(fit.fit, e.policy.judgement);
    Verdict verdict{VerdictKind::effects, fit.fit.effects};
    verdict.trust = policy.undoubted * (effect_bound || modulus_bound ? policy.at_bound : 1.0);
    verdict.confidence = verdict.trust * weight;
    verdict.reason = systematic_fall(fit, e.diagnosis.declared);
    if (effect_bound)
        add_caution(verdict, "Its size reached its limit: it may represent another effect of that kind and place.");
    if (fit.drifts()) add_caution(verdict, "The rest is measurement drift: it is uncorrelated between markers.");
    if (modulus_bound)
        add_caution(verdict, "The modulus ends at a bound with the effect as without it: its value is not reliable.");
    return {verdict, fit};
}

/// Verdict `unknown`, with the better of the best single effect and the best set.
Conclusion unexplained(const VerdictEvidence& e) {
    const Diagnosis& d = e.diagnosis;
    const VerdictPolicy& policy = e.policy.verdict;
    const bool by_set = e.set && e.single && e.set->criterion < e.single->criterion;
    const JudgedFit& best = by_set ? *e.set : e.single ? *e.single : d.declared;
    const double left = best.tests.systematic.rms / std::max(policy.least_systematic, d.declared.tests.systematic.rms);
    Verdict verdict{VerdictKind::unknown};
    verdict.confidence = policy.undoubted * std::min(1.0, policy.nearly_explained + policy.unexplained_growth * left);
    verdict.reason = "the residual is significant, and " +
                     std::string(d.search_complete
                                     ? "no effect of the catalogue takes it away"
                                     : "no effect that takes it away was found in the time for the search") +
                     ": the best attempt leaves " + times_noise(best.tests.systematic.rms) + " of " +
                     times_noise(d.declared.tests.systematic.rms) + ".";
    return {verdict, best};
}

/// Whether a fit removes most of the residual, where the noise was not declared. A modulus at a bound counts against
/// the effect only if the declared fit has none there: muscles at unknown levels, for example, hardly determine it.
bool removes_most(const VerdictEvidence& e, const JudgedFit& fit) {
    const Diagnosis& d = e.diagnosis;
    const VerdictPolicy& policy = e.policy.verdict;
    const JudgementPolicy& judgement = e.policy.judgement;
    if (d.data.noise_declared || !fit.usable() || !differs_from_zero(fit.fit, judgement) ||
        (modulus_at_bound(fit.fit, judgement) && !modulus_at_bound(d.declared.fit, judgement)))
        return false;
    const auto leaves = [&](double JudgedFit::*rms, double share) { return fit.*rms <= share * d.declared.*rms; };
    const bool untested_by_trials = fit.single_trial_directions > d.declared.single_trial_directions;
    return leaves(&JudgedFit::rms_m, policy.max_left) && leaves(&JudgedFit::held_out_rms, policy.max_left_held_out) &&
           (!untested_by_trials || leaves(&JudgedFit::held_out_in_time_rms, policy.max_left_held_out));
}

/// Whether a set hardly leaves less than its best effect alone.
bool is_idle(const VerdictEvidence& e) {
    return e.single &&
           e.set->tests.systematic.rms > e.policy.judgement.most_of_residual * e.single->tests.systematic.rms;
}

/// Whether the best single effect leaves so little that only its form may be wrong (VerdictPolicy::nearly_all).
bool removes_nearly_all(const VerdictEvidence& e) {
    const Diagnosis& d = e.diagnosis;
    const JudgedFit& fit = *e.single;
    return may_explain(fit, d.baseline()) && presence(d, fit) > e.policy.verdict.present &&
           !effect_at_bound(fit.fit, e.policy.judgement) &&
           fit.tests.systematic.rms <= e.policy.verdict.nearly_all * d.declared.tests.systematic.rms;
}

/// explains() with the tolerance of the verdict.
bool explains_all(const VerdictEvidence& e, const JudgedFit& fit) { return explains(fit, e.diagnosis.baseline()); }

/// Weight among the fits that explain the residual. Others do not count, even if they predict held-out trials better.
double weight_among_explaining(const VerdictEvidence& e, const JudgedFit& fit) {
    std::vector<const JudgedFit*> others;
    const auto add = [&](const JudgedFit& other) {
        if (&other != &fit && explains_all(e, other)) others.push_back(&other);
    };
    for (const Candidate& candidate : e.diagnosis.candidates)
        if (candidate.judged) add(*candidate.judged);
    for (const JudgedFit& set : e.diagnosis.sets) add(set);
    return weight_among(fit, others, e.policy.judgement);
}

/// Probability that an effect acts alone. If a set fits better although the first effect explains the residual, the
/// second may compensate for the mesh error.
double weight_alone(const VerdictEvidence& e, const JudgedFit& fit) {
    return std::max(fit.weight, e.policy.verdict.other_form *
                                    std::max(presence(e.diagnosis, fit), weight_among_explaining(e, fit)));
}

/// One effect removes nearly all, but the data do not determine which others remove the rest.
bool second_is_open(const VerdictEvidence& e) {
    return e.single && removes_nearly_all(e) && presence(e.diagnosis, *e.set) < e.policy.verdict.second_effect;
}

/// Names the single effect, with reduced confidence.
Conclusion nearly_all(const VerdictEvidence& e) {
    const Diagnosis& d = e.diagnosis;
    Conclusion conclusion = named(e, *e.single, e.policy.verdict.other_form * presence(d, *e.single));
    add_caution(conclusion.verdict,
                "A residual remains: the effect may act in another form than assumed here" +
                    std::string(d.sets.empty() ? "." : ", or with another one that is too small to identify."));
    return conclusion;
}

/// Names effects whose remainder is not compared with the noise, which is not that of the model's error.
Conclusion most_of_it(const VerdictEvidence& e, const JudgedFit& fit, double weight) {
    const double left = fit.rms_m / e.diagnosis.declared.rms_m;
    Conclusion conclusion = named(e, fit, weight * (1.0 - e.policy.verdict.discount_of_left * left));
    add_caution(conclusion.verdict,
                "The rest is unexplained: the noise was measured on still markers, and no model of a real body "
                "reaches it.");
    return conclusion;
}

/// Whether the residual of the declared fit needs no explanation.
bool nothing_to_explain(const VerdictEvidence& e) { return !needs_explanation(e.diagnosis.baseline()); }

}  // namespace

std::string times_noise(double rms) { return format_number(rms, 3) + " times the noise"; }

std::string effects_in_words(const std::vector<effect::EffectDeclaration>& effects) {
    assert(!effects.empty());
    std::string words;
    for (std::size_t i = 0; i < effects.size(); ++i)
        words += (i == 0 ? "" : i + 1 == effects.size() ? " and " : ", ") + effect_words(effects[i]);
    return words;
}

std::string systematic_fall(const JudgedFit& fit, const JudgedFit& declared) {
    return "with " + effects_in_words(fit.fit.effects) + " the systematic part falls from " +
           times_noise(declared.tests.systematic.rms) + " to " + times_noise(fit.tests.systematic.rms) + ".";
}

VerdictEvidence verdict_evidence(const Diagnosis& d) {
    VerdictEvidence e{d, d.settings.policy};
    if (!d.candidates.empty() && d.candidates.front().judged) e.single = &*d.candidates.front().judged;
    if (!d.sets.empty() && !is_untested(d.sets.front(), d.declared)) e.set = &d.sets.front();
    return e;
}

const std::vector<VerdictRule>& verdict_rules() {
    using Evidence = VerdictEvidence;
    static const std::vector<VerdictRule> rules{
        {"drift", [](const Evidence& e) { return nothing_to_explain(e) && e.diagnosis.declared.drifts(); }, drift},
        {"nothing_missing", nothing_to_explain, nothing_missing},
        {"single_effect", [](const Evidence& e) { return e.single && explains_all(e, *e.single); },
         [](const Evidence& e) { return named(e, *e.single, weight_alone(e, *e.single)); }},
        {"set", [](const Evidence& e) { return e.set && explains_all(e, *e.set) && !is_idle(e) && !second_is_open(e); },
         [](const Evidence& e) {
             return named(e, *e.set, e.policy.verdict.other_form * presence(e.diagnosis, *e.set));
         }},
        {"nearly_all", [](const Evidence& e) { return e.single && removes_nearly_all(e); }, nearly_all},
        {"most_by_set",
         [](const Evidence& e) {
             return e.set && e.single && removes_most(e, *e.set) && e.set->criterion < e.single->criterion &&
                    !is_idle(e);
         },
         [](const Evidence& e) { return most_of_it(e, *e.set, presence(e.diagnosis, *e.set)); }},
        {"most_by_single", [](const Evidence& e) { return e.single && removes_most(e, *e.single); },
         [](const Evidence& e) { return most_of_it(e, *e.single, presence(e.diagnosis, *e.single)); }},
        {"faint", [](const Evidence& e) { return is_faint(e.diagnosis.baseline()); }, nothing_missing},
        {"unexplained", [](const Evidence&) { return true; }, unexplained},
    };
    return rules;
}

}  // namespace myo::diagnosis
