#include "diagnosis/screening/confusion.hpp"

#include <algorithm>
#include <cmath>

#include "diagnosis/diagnosis_policy.hpp"
#include "effect/catalogue.hpp"

namespace myo::diagnosis {
namespace {

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

/// Cosine between the changes of the declared residual by two fitted candidates; 0 unless both fits have a comparable
/// weight.
double cosine_of_fits(const Candidate& a, const Candidate& b, const JointFit& declared) {
    if (!a.judged || !b.judged ||
        std::min(a.judged->weight, b.judged->weight) < diagnosis_policy.confusion.comparable_weight)
        return 0.0;
    const Eigen::VectorXd of_a = a.judged->fit.residual - declared.residual,
                          of_b = b.judged->fit.residual - declared.residual;
    return std::abs(of_a.normalized().dot(of_b.normalized()));
}

bool is_named(const Diagnosis& d, const std::string& id) {
    return std::any_of(d.verdict.effects.begin(), d.verdict.effects.end(),
                       [&](const effect::EffectDeclaration& effect) { return effect.id == id; });
}

}  // namespace

void find_confusions(Diagnosis& d) {
    d.confusions.clear();
    double most = 0.0;
    for (const Candidate& candidate : d.candidates)
        if (candidate.score.usable()) most = std::max(most, candidate.score.test.explained);
    for (std::size_t i = 0; i < d.candidates.size(); ++i)
        for (std::size_t j = i + 1; j < d.candidates.size(); ++j) {
            Candidate& a = d.candidates[i];
            Candidate& b = d.candidates[j];
            const bool foretold = a.score.usable() && b.score.usable() &&
                                  std::min(a.score.test.explained, b.score.test.explained) >=
                                      diagnosis_policy.confusion.least_reduction * most;
            const double cosine = std::max(
                foretold ? std::abs(statistics::principal_cosine(a.score.candidate, b.score.candidate)) : 0.0,
                cosine_of_fits(a, b, d.declared.fit));
            if (cosine < diagnosis_policy.confusion.least_cosine) continue;
            a.like.push_back(b.score.id);
            b.like.push_back(a.score.id);
            d.confusions.push_back({a.score.id, b.score.id, cosine,
                                    advice(*effect::find_effect(a.score.id), *effect::find_effect(b.score.id))});
        }
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
            return c.score.id == id && c.judged && c.judged->weight < diagnosis_policy.confusion.comparable_weight;
        });
    };
    return (is_named(d, confusion.first) && refuted(confusion.second)) ||
           (is_named(d, confusion.second) && refuted(confusion.first));
}

}  // namespace myo::diagnosis
