#include "diagnosis/verdict/probabilities.hpp"

#include <algorithm>
#include <vector>

namespace myo::diagnosis {
namespace {

using Effects = std::vector<effect::EffectDeclaration>;

/// Whether an effect of this id is among the given ones.
bool acts_in(const Effects& effects, const std::string& id) {
    return std::any_of(effects.begin(), effects.end(),
                       [&](const effect::EffectDeclaration& effect) { return effect.id == id; });
}

/// All fits with tried effects: single ones and sets.
std::vector<const JudgedFit*> fits_of(const Diagnosis& d) {
    std::vector<const JudgedFit*> fits;
    for (const Candidate& candidate : d.candidates)
        if (candidate.judged) fits.push_back(&*candidate.judged);
    for (const JudgedFit& set : d.sets) fits.push_back(&set);
    return fits;
}

}  // namespace

double presence(const Diagnosis& d, const JudgedFit& fit) {
    double weight = 0.0;
    for (const JudgedFit* other : fits_of(d)) {
        const Effects& effects = other->fit.effects;
        if (std::all_of(fit.fit.effects.begin(), fit.fit.effects.end(),
                        [&](const effect::EffectDeclaration& effect) { return acts_in(effects, effect.id); }))
            weight += other->weight;
    }
    return std::min(1.0, weight);
}

std::map<std::string, double> effect_probabilities(const Diagnosis& d) {
    // Without named effects all candidates share what the verdict leaves over.
    const double share = d.verdict.kind == VerdictKind::effects ? d.verdict.trust : 1.0 - d.verdict.confidence;
    std::map<std::string, double> probabilities;
    for (const Candidate& candidate : d.candidates) {
        double weight = 0.0;
        for (const JudgedFit* fit : fits_of(d))
            if (acts_in(fit->fit.effects, candidate.score.id)) weight += fit->weight;
        probabilities[candidate.score.id] = share * std::min(1.0, weight);
    }
    if (d.verdict.kind == VerdictKind::effects)
        for (const effect::EffectDeclaration& effect : d.verdict.effects)
            probabilities[effect.id] = std::max(probabilities[effect.id], d.verdict.confidence);
    // The data do not separate twins: each gets an equal share of their sum.
    for (const std::vector<std::string>& group : d.verdict.twins) {
        double all = 0.0;
        for (const std::string& id : group) all += probabilities[id];
        for (const std::string& id : group)
            probabilities[id] = std::min(all, d.verdict.trust) / static_cast<double>(group.size());
    }
    return probabilities;
}

double confidence_in(const Diagnosis& d, const std::string& effect) {
    return d.verdict.effects.size() > 1 ? effect_probabilities(d).at(effect) : d.verdict.confidence;
}

}  // namespace myo::diagnosis
