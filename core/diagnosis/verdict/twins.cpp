#include "diagnosis/verdict/twins.hpp"

#include <algorithm>
#include <cmath>

#include "diagnosis/selection/ranking.hpp"
#include "statistics/nuisance_space.hpp"

namespace myo::diagnosis {
namespace {

using Effects = std::vector<effect::EffectDeclaration>;

/// Best fit of these effects; null if none was made.
const JudgedFit* fit_of(const Diagnosis& d, const Effects& effects) {
    if (effects.empty()) return &d.declared;
    for (const Candidate& candidate : d.candidates)
        if (candidate.judged && have_same_ids(candidate.judged->fit.effects, effects)) return &*candidate.judged;
    for (const JudgedFit& set : d.sets)
        if (have_same_ids(set.fit.effects, effects)) return &set;
    return nullptr;
}

/// The named effects with one of them exchanged for another.
Effects exchanged(Effects named, const std::string& effect, const std::string& other) {
    for (effect::EffectDeclaration& member : named)
        if (member.id == effect) member = {other, {}, false};
    return named;
}

/// Evidence of the group over that of its named effect.
double weight_of_group(const Diagnosis& d, const std::string& effect, const std::vector<std::string>& others) {
    const JudgedFit* const named = fit_of(d, d.verdict.effects);
    if (!named || !(named->weight > 0.0)) return 1.0;
    double sum = named->weight;
    for (const std::string& other : others) sum += fit_of(d, exchanged(d.verdict.effects, effect, other))->weight;
    return sum / named->weight;
}

}  // namespace

std::vector<std::string> twins_of(const Diagnosis& d, const std::string& effect) {
    const Effects& named = d.verdict.effects;
    Effects rest;
    for (const effect::EffectDeclaration& member : named)
        if (member.id != effect) rest.push_back(member);
    const JudgedFit* const with = fit_of(d, named);
    const JudgedFit* const without = fit_of(d, rest);
    if (!with || !without || with->fit.residual.size() != without->fit.residual.size()) return {};
    const statistics::NuisanceSpace nuisance(d.declared.fit.jacobian);
    // Unit vector of what the effect changes, outside the space of the declared parameters.
    const auto contribution = [&](const JudgedFit& fit) {
        return Eigen::VectorXd(nuisance.outside(fit.fit.residual - without->fit.residual)).normalized();
    };
    const Eigen::VectorXd own = contribution(*with);
    std::vector<std::string> twins;
    for (const Candidate& candidate : d.candidates) {
        const std::string& id = candidate.score.id;
        // Effects that are named themselves are no alternatives.
        if (std::any_of(named.begin(), named.end(), [&](const auto& member) { return member.id == id; })) continue;
        const JudgedFit* const other = fit_of(d, exchanged(named, effect, id));
        if (!other || !other->usable() || other->fit.residual.size() != own.size()) continue;
        // Far from the declared model all that come near do nearly the same: what they leave tells them apart.
        if (other->fit.squares() > d.settings.policy.search.rival_factor * with->fit.squares()) continue;
        const double cosine = std::abs(own.dot(contribution(*other)));
        if (cosine >= d.settings.policy.confusion.twin_cosine) twins.push_back(id);
    }
    return twins;
}

Diagnosis with_twins(Diagnosis d) {
    if (d.verdict.kind != VerdictKind::effects) return d;
    std::vector<std::string>& ranking = d.verdict.ranking;
    auto place = ranking.begin() + static_cast<std::ptrdiff_t>(d.verdict.effects.size());
    for (const effect::EffectDeclaration& effect : d.verdict.effects) {
        const std::vector<std::string> others = twins_of(d, effect.id);
        if (others.empty()) continue;
        // Twins move up in the ranking, behind all named effects.
        d.verdict.twins.push_back({effect.id});
        for (const std::string& other : others) {
            d.verdict.twins.back().push_back(other);
            if (const auto found = std::find(place, ranking.end(), other); found != ranking.end()) {
                std::rotate(place, found, found + 1);
                ++place;
            }
        }
        // The evidence of the group counts for its members together; each then has an equal share.
        const double of_group = d.verdict.confidence * weight_of_group(d, effect.id, others);
        d.verdict.confidence = std::min(d.verdict.trust, of_group) / static_cast<double>(others.size() + 1);
    }
    return d;
}

}  // namespace myo::diagnosis
