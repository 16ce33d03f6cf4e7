#include "loop/confusion.hpp"

#include <algorithm>
#include <cmath>

#include "effect/catalogue.hpp"

namespace myo {
namespace {

/// From this cosine on two effects count as one to this experiment.
constexpr double alike = 0.97;
/// What explains a smaller share of the residual than this part of what the best does is out of the question anyway.
constexpr double worth_naming = 0.3;

std::string advice(const Effect& first, const Effect& second) {
    const auto either = [&](EffectStage stage) { return first.stage == stage || second.stage == stage; };
    if (either(EffectStage::actuation)) return "a trial with a slow ramp of the actuation beside one with a step";
    if (either(EffectStage::measurement)) return "a trial in which the body is at rest, with the cameras moved or recalibrated";
    if (either(EffectStage::support) && either(EffectStage::material)) return "a trial loaded near the clamp beside one loaded at the end, with a marker next to the clamp";
    if (either(EffectStage::material) && either(EffectStage::force)) return "a release from a larger deflection, with a longer record at rest afterwards";
    if (either(EffectStage::force)) return "a release of the same body turned by 90 degrees about its axis, and one with another end load";
    return "releases from two other deflections, one small and one large";
}

}  // namespace

void find_confusions(const Study&, Diagnosis& d) {
    d.confusions.clear();
    double most = 0.0;
    for (const Candidate& candidate : d.candidates)
        if (candidate.score.usable()) most = std::max(most, candidate.score.test.explained);
    for (std::size_t i = 0; i < d.candidates.size(); ++i)
        for (std::size_t j = i + 1; j < d.candidates.size(); ++j) {
            Candidate& a = d.candidates[i];
            Candidate& b = d.candidates[j];
            if (!a.score.usable() || !b.score.usable() || std::min(a.score.test.explained, b.score.test.explained) < worth_naming * most) continue;
            const double cosine = std::abs(principal_cosine(a.score.candidate, b.score.candidate));
            if (cosine < alike) continue;
            a.like.push_back(b.score.id);
            b.like.push_back(a.score.id);
            d.confusions.push_back({a.score.id, b.score.id, cosine, advice(*find_effect(a.score.id), *find_effect(b.score.id))});
        }
}

}  // namespace myo
