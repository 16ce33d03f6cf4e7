#include "diagnosis/verdict.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "diagnosis/effect_words.hpp"
#include "diagnosis/judge.hpp"

namespace myo::diagnosis {
namespace {

/// Confidence in a verdict of which no test and no rival leaves a doubt: 153 of 161 such verdicts were right in the
/// setup of assets/setup/seed_1 (91 to 98 %), where a sixth of the effects is not in the catalogue.
constexpr double trust = 0.93;
/// Cameras alone, at rest, are far better than any model of a real body. Where nobody says how good a model could be,
/// an effect is named that leaves at most this share of the rms, and this on samples it was not fitted to: of the
/// squares a quarter, and a half.
constexpr double most_left = 0.5, most_left_held_out = 0.7;
/// An effect that leaves less of what was systematic is named though a test still fires: its law may be of another form
/// than ours.
constexpr double nearly_all = 0.125;
/// Of the confidence in it, and in two effects that explain the residual: they may stand in for one that acts in
/// another form.
constexpr double other_form_trust = 0.6;
/// A second effect is named where it is that likely: small rests, of the mesh say, are taken away by many.
constexpr double decided = 0.8;
/// Of the confidence that none of the catalogue explains what the best attempt nearly does; in full where that takes
/// little away. In the setup of assets/setup/seed_1 all such answers were right.
constexpr double surely_unknown = 0.8;
/// A prediction is worse where it is farther off by this factor and not as good as noise allows. What is left of the
/// confidence then.
constexpr double worse = 1.1, as_good_as_noise = 1.3, contradicted_trust = 0.5;
/// Of the confidence that nothing is missing where what is left is the measurement's: no setup has counted how often
/// that is right.
constexpr double wander_trust = 0.7;
/// Of the confidence in an effect whose size, or beside which the modulus, ends at its bound.
constexpr double at_bound_trust = 0.5;

std::string times_noise(double rms) { return format_number(rms, 3) + " times the noise"; }

/// Ids of the candidates, most credible first, with the verdict's first.
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

JudgedFit none(Diagnosis& d) {
    d.verdict.kind = VerdictKind::none;
    const double share = d.declared.tests.systematic.rms / numerical_allowance(d.data, d.numerics);
    d.verdict.confidence = trust * (d.declared.tests.significant() ? std::clamp(1.5 - share, 0.3, 1.0) : 1.0);
    d.verdict.because = "what the declared model leaves is " + times_noise(d.declared.rms_m / d.noise_m) +
                        ", of which " + times_noise(d.declared.tests.systematic.rms) + " is systematic: " +
                        (share > 1.0 ? "little, and no effect takes most of it away."
                                     : "no more than the program's own error may be.");
    return d.declared;
}

/// What no force on a body does: each marker by itself.
JudgedFit wander(Diagnosis& d) {
    d.verdict.kind = VerdictKind::none;
    d.verdict.confidence = trust * wander_trust;
    d.verdict.because = "what the declared model leaves is " + times_noise(d.declared.rms_m / d.noise_m) +
                        ", of which " + times_noise(d.declared.tests.systematic.rms) +
                        " is no white noise, but every marker has its own and none goes with another: no force on the "
                        "body does that. The measurement wanders.";
    return d.declared;
}

std::string effects_in_words(const std::vector<effect::EffectDeclaration>& effects) {
    return effect_words(effects.front()) + (effects.size() > 1 ? " and " + effect_words(effects.back()) : "");
}

std::string falls_with(const JudgedFit& fit, const JudgedFit& declared) {
    return "with " + effects_in_words(fit.fit.effects) + " the systematic part falls from " +
           times_noise(declared.tests.systematic.rms) + " to " + times_noise(fit.tests.systematic.rms) + ".";
}

void say_but(Verdict& verdict, const std::string& sentence) {
    verdict.but += " " + sentence;
    verdict.because += " " + sentence;
}

JudgedFit effects(Diagnosis& d, const JudgedFit& fit, double weight) {
    d.verdict.kind = VerdictKind::effects;
    d.verdict.effects = fit.fit.effects;
    const bool effect_bound = effect_at_bound(fit.fit), modulus_bound = modulus_at_bound(fit.fit);
    d.verdict.confidence = trust * weight * (effect_bound || modulus_bound ? at_bound_trust : 1.0);
    d.verdict.because = falls_with(fit, d.declared);
    if (effect_bound)
        say_but(d.verdict,
                "Its size went as far as it may: it may stand in for something else of that kind and place.");
    if (fit.wanders()) say_but(d.verdict, "What is left is the measurement's: every marker goes its own way.");
    if (modulus_bound)
        say_but(d.verdict,
                "The modulus ends at a bound with the effect as without it: its value is not to be relied on.");
    return fit;
}

JudgedFit unknown(Diagnosis& d, const JudgedFit& best) {
    d.verdict.kind = VerdictKind::unknown;
    const double left = best.tests.systematic.rms / std::max(1e-9, d.declared.tests.systematic.rms);
    d.verdict.confidence = trust * std::min(1.0, surely_unknown + 0.4 * left);
    d.verdict.because =
        "the residual is significant, and no effect of the catalogue takes it away: the best attempt leaves " +
        times_noise(best.tests.systematic.rms) + " of " + times_noise(d.declared.tests.systematic.rms) + ".";
    return best;
}

/// A modulus that the declared model left at a bound, too, says nothing against the effect: muscles at unknown levels,
/// for one, hardly determine it.
bool takes_most(const Diagnosis& d, const JudgedFit& fit) {
    if (d.data.noise_declared || !fit.usable() || !is_told_from_nothing(fit.fit) ||
        (modulus_at_bound(fit.fit) && !modulus_at_bound(d.declared.fit)))
        return false;
    const auto leaves = [&](double JudgedFit::*rms, double share) { return fit.*rms <= share * d.declared.*rms; };
    const bool untested_by_trials = fit.told_by_one > d.declared.told_by_one;
    return leaves(&JudgedFit::rms_m, most_left) && leaves(&JudgedFit::held_out_rms, most_left_held_out) &&
           (!untested_by_trials || leaves(&JudgedFit::held_out_in_time_rms, most_left_held_out));
}

bool acts_in_one_trial(const effect::EffectDeclaration& effect) { return effect::has(effect.parameters, "trial"); }

/// Two effects at once fit much that neither makes. Where one of their numbers can be told from one trial only, as how
/// much a material drifts between two, no other trial tests it: of single effects the residual itself does, of two it
/// hardly does. What acts in one trial cannot be tested by others.
bool is_untested(const Diagnosis& d, const JudgedFit& pair) {
    return pair.told_by_one > d.declared.told_by_one &&
           std::none_of(pair.fit.effects.begin(), pair.fit.effects.end(), acts_in_one_trial);
}

/// The second effect of a pair hardly does anything.
bool is_idle(const JudgedFit& pair, const JudgedFit& first) {
    return pair.tests.systematic.rms > most_of_what_was * first.tests.systematic.rms;
}

/// That the effect of a fit acts, alone or beside another.
double presence(const Diagnosis& d, const JudgedFit& fit) {
    const auto is_it = [&](const effect::EffectDeclaration& effect) { return effect.id == fit.fit.effects.front().id; };
    double weight = fit.weight;
    for (const JudgedFit& pair : d.pairs)
        if (std::any_of(pair.fit.effects.begin(), pair.fit.effects.end(), is_it)) weight += pair.weight;
    return std::min(1.0, weight);
}

bool takes_nearly_all(const Diagnosis& d, const JudgedFit& fit) {
    return may_explain(fit, d.declared) && presence(d, fit) > 0.5 && !effect_at_bound(fit.fit) &&
           fit.tests.systematic.rms <= nearly_all * d.declared.tests.systematic.rms;
}

/// Of what explains the residual, this: fits that do not may predict held-out trials better, and are not the answer.
double among_explaining(const Diagnosis& d, const JudgedFit& fit) {
    std::vector<const JudgedFit*> others;
    const auto add = [&](const JudgedFit& other) {
        if (&other != &fit && explains(other, d.declared, d.data, d.numerics)) others.push_back(&other);
    };
    for (const Candidate& candidate : d.candidates)
        if (candidate.judged) add(*candidate.judged);
    for (const JudgedFit& pair : d.pairs) add(pair);
    return weight_among(fit, others);
}

/// That it acts and is all there is: where seconds beside it would fit better still, though it explains the residual
/// alone, they may be fitting the mesh.
double alone(const Diagnosis& d, const JudgedFit& fit) {
    return std::max(fit.weight, other_form_trust * std::max(presence(d, fit), among_explaining(d, fit)));
}

/// One effect takes away nearly all, and which does the rest beside it is open.
bool any_would_do(const Diagnosis& d, const JudgedFit& first) {
    return takes_nearly_all(d, first) && d.pairs.front().weight < decided;
}

JudgedFit nearly_all_of_it(Diagnosis& d, const JudgedFit& fit) {
    effects(d, fit, other_form_trust * presence(d, fit));
    say_but(d.verdict, "That is not all: the effect may act in another form than the one it was given here" +
                           std::string(d.pairs.empty() ? "." : ", or beside another, too small to tell which."));
    return fit;
}

JudgedFit most_of_it(Diagnosis& d, const JudgedFit& fit, double weight) {
    const double left = fit.rms_m / d.declared.rms_m;
    effects(d, fit, weight * (1.0 - 0.5 * left));
    say_but(d.verdict,
            "What is left is unexplained: the noise was taken from still markers, and no model of a real body comes "
            "down to that.");
    return fit;
}

}  // namespace

std::string above_noise_note(const NumericalError& numerics, double noise_m) {
    const bool by_mesh = numerics.mesh_rms_m >= numerics.step_rms_m;
    return "what extrapolation may leave of the errors of mesh and step, " +
           times_noise(numerics.left_rms_m / noise_m) + ", is above the noise (mesh " +
           times_noise(numerics.mesh_rms_m / noise_m) + ", step " + times_noise(numerics.step_rms_m / noise_m) +
           "): choose a " + (by_mesh ? "finer --resolution" : "smaller --dt") + " before trusting small effects";
}

JudgedFit decide(Diagnosis& d) {
    JudgedFit fit;
    const Candidate* const first = !d.candidates.empty() && d.candidates.front().judged ? &d.candidates.front()
                                                                                        : nullptr;
    const JudgedFit* const pair = d.pairs.empty() || is_untested(d, d.pairs.front()) ? nullptr : &d.pairs.front();
    if (!needs_explanation(d.declared, d.data, d.numerics))
        fit = d.declared.wanders() ? wander(d) : none(d);
    else if (first && explains(*first->judged, d.declared, d.data, d.numerics))
        fit = effects(d, *first->judged, alone(d, *first->judged));
    else if (pair && explains(*pair, d.declared, d.data, d.numerics) &&
             !(first && (is_idle(*pair, *first->judged) || any_would_do(d, *first->judged))))
        fit = effects(d, *pair, other_form_trust * pair->weight);
    else if (first && takes_nearly_all(d, *first->judged))
        fit = nearly_all_of_it(d, *first->judged);
    else if (pair && takes_most(d, *pair) && first && pair->criterion < first->judged->criterion &&
             !is_idle(*pair, *first->judged))
        fit = most_of_it(d, *pair, pair->weight);
    else if (first && takes_most(d, *first->judged))
        fit = most_of_it(d, *first->judged, presence(d, *first->judged));
    else if (is_faint(d.declared, d.data, d.numerics))
        fit = none(d);
    else
        fit = unknown(d, pair && first && pair->criterion < first->judged->criterion ? *pair
                         : first                                                     ? *first->judged
                                                                                     : d.declared);
    if (d.verdict.kind == VerdictKind::unknown && !d.pairs.empty() && is_untested(d, d.pairs.front()) &&
        explains(d.pairs.front(), d.declared, d.data, d.numerics))
        d.notes.push_back(effects_in_words(d.pairs.front().fit.effects) +
                          " together would explain it, but one of their numbers rests on a single trial: a further "
                          "trial to fit would tell");
    if (d.numerics.left_rms_m > d.noise_m) d.notes.push_back(above_noise_note(d.numerics, d.noise_m));
    rank(d);
    return fit;
}

void take_over_settled(Diagnosis& d) {
    if (d.verdict.kind != VerdictKind::effects) return;
    d.verdict.effects = d.augmented.fit.effects;
    d.verdict.because = falls_with(d.augmented, d.declared) + d.verdict.but;
    const auto same = [&](const JudgedFit& fit) {
        return fit.fit.effects.size() == d.verdict.effects.size() &&
               std::equal(
                   fit.fit.effects.begin(), fit.fit.effects.end(), d.verdict.effects.begin(),
                   [](const effect::EffectDeclaration& a, const effect::EffectDeclaration& b) { return a.id == b.id; });
    };
    const auto take_over = [&](JudgedFit& fit) {
        const double weight = fit.weight;  // it was chosen with
        fit = d.augmented;
        fit.weight = weight;
    };
    for (Candidate& candidate : d.candidates)
        if (candidate.judged && same(*candidate.judged)) take_over(*candidate.judged);
    for (JudgedFit& pair : d.pairs)
        if (same(pair)) take_over(pair);
}

void doubt_worse_predictions(Diagnosis& d) {
    const double before = d.before.validation_rms_m, after = d.after.validation_rms_m;
    if (d.verdict.kind != VerdictKind::effects || !(after > worse * before) || !(after > as_good_as_noise * d.noise_m))
        return;
    d.verdict.confidence *= contradicted_trust;
    d.notes.push_back("trials that took no part are predicted worse with " + effects_in_words(d.verdict.effects) +
                      ", " + times_noise(after / d.noise_m) + " instead of " + times_noise(before / d.noise_m) +
                      ": do not rely on this answer; what is missing may be something else, or differ in these trials");
}

}  // namespace myo::diagnosis
