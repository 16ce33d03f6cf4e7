#include "diagnosis/screening/confusion.hpp"

#include <algorithm>
#include <cmath>

#include "diagnosis/diagnosis.hpp"
#include "effect/catalogue.hpp"

namespace myo::diagnosis {
namespace {

/// Experiment that separates two effects, by their kinds; the first case that applies decides.
std::string advice(const effect::Effect& first, const effect::Effect& second) {
    const auto either = [&](effect::EffectKind kind) { return first.kind == kind || second.kind == kind; };
    if (either(effect::EffectKind::actuation)) return "a trial with a slow ramp of the actuation and one with a step";
    if (either(effect::EffectKind::measurement))
        return "a trial in which the body is at rest, with the cameras moved or recalibrated";
    if (either(effect::EffectKind::support) && either(effect::EffectKind::material))
        return "a trial loaded near the clamp and one loaded at the end, with a marker next to the clamp";
    if (either(effect::EffectKind::material) && either(effect::EffectKind::force))
        return "a release from a larger deflection, with a longer record at rest afterwards";
    if (either(effect::EffectKind::force))
        return "a release of the same body turned by 90 degrees about its axis, and one with another end load";
    return "releases from two other deflections, one small and one large";
}

/// Entry of the effect in the catalogue, or its law.
const effect::Effect& entry_of(const EffectScore& score) {
    return score.law ? *score.law : *effect::find_effect(score.id);
}

/// Cosine between the changes of the residual by two effects that their scores predict; 0 if one of them predicts a
/// far smaller reduction than the best candidate.
double predicted_cosine(const Candidate& a, const Candidate& b, double largest_reduction,
                        const ConfusionPolicy& policy) {
    if (!a.score.usable() || !b.score.usable() ||
        std::min(a.score.test.explained, b.score.test.explained) < policy.min_reduction * largest_reduction)
        return 0.0;
    return std::abs(statistics::principal_cosine(a.score.candidate, b.score.candidate));
}

/// Cosine between the changes of the declared residual by two fitted candidates; 0 unless both fits have a comparable
/// weight.
double fitted_cosine(const Candidate& a, const Candidate& b, const JointFit& declared, const ConfusionPolicy& policy) {
    if (!a.judged || !b.judged || std::min(a.judged->weight, b.judged->weight) < policy.comparable_weight) return 0.0;
    // Changes from the declared residual, not residuals: what two good fits leave is the noise, which they share.
    const Eigen::VectorXd of_a = a.judged->fit.residual - declared.residual,
                          of_b = b.judged->fit.residual - declared.residual;
    return std::abs(of_a.normalized().dot(of_b.normalized()));
}

/// Whether the verdict names this effect.
bool is_named(const Diagnosis& d, const std::string& id) {
    return std::any_of(d.verdict.effects.begin(), d.verdict.effects.end(),
                       [&](const effect::EffectDeclaration& effect) { return effect.id == id; });
}

}  // namespace

std::vector<Confusion> find_confusions(const std::vector<Candidate>& candidates, const JointFit& declared,
                                       const ConfusionPolicy& policy) {
    double largest = 0.0;
    for (const Candidate& candidate : candidates)
        if (candidate.score.usable()) largest = std::max(largest, candidate.score.test.explained);
    std::vector<Confusion> confusions;
    for (auto a = candidates.begin(); a != candidates.end(); ++a)
        for (auto b = a + 1; b != candidates.end(); ++b) {
            // Either is enough: scores are linear, and only the best candidates have a fit.
            const double cosine = std::max(predicted_cosine(*a, *b, largest, policy),
                                           fitted_cosine(*a, *b, declared, policy));
            if (cosine < policy.min_cosine) continue;
            const std::string &first = a->score.id, &second = b->score.id;
            confusions.push_back({first, second, cosine, advice(entry_of(a->score), entry_of(b->score))});
        }
    return confusions;
}

std::vector<Candidate> with_confusions(std::vector<Candidate> candidates, const std::vector<Confusion>& confusions) {
    for (Candidate& candidate : candidates) {
        candidate.confounded_with.clear();
        for (const Confusion& confusion : confusions) {
            if (confusion.first == candidate.score.id) candidate.confounded_with.push_back(confusion.second);
            if (confusion.second == candidate.score.id) candidate.confounded_with.push_back(confusion.first);
        }
    }
    return candidates;
}

std::vector<Confusion> confusions_of_verdict(const Diagnosis& d) {
    std::vector<Confusion> result;
    for (const Confusion& c : d.confusions)
        if (d.verdict.kind != VerdictKind::effects || is_named(d, c.first) || is_named(d, c.second))
            result.push_back(c);
    return result;
}

bool is_decided(const Diagnosis& d, const Confusion& confusion) {
    const auto refuted = [&](const std::string& id) {
        return std::any_of(d.candidates.begin(), d.candidates.end(), [&](const Candidate& c) {
            return c.score.id == id && c.judged && c.judged->weight < d.settings.policy.confusion.comparable_weight;
        });
    };
    return (is_named(d, confusion.first) && refuted(confusion.second)) ||
           (is_named(d, confusion.second) && refuted(confusion.first));
}

}  // namespace myo::diagnosis
