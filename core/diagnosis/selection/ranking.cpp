#include "diagnosis/selection/ranking.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "statistics/autocorrelation.hpp"
#include "statistics/evidence.hpp"

namespace myo::diagnosis {
namespace {

/// Criteria of fits of the same data, compared by one of their errors on held-out data.
/// @param effective  number of independent samples of the best residual
std::vector<double> criteria_of(const std::vector<const JudgedFit*>& fits, double samples, double effective,
                                double JudgedFit::*held_out, const JudgementPolicy& policy) {
    std::vector<double> criteria;
    for (const JudgedFit* fit : fits) {
        if (!fit->usable()) {
            criteria.push_back(std::numeric_limits<double>::infinity());
            continue;
        }
        // The penalty for an effect at a bound is twice the logarithm of the odds against it, in units that the
        // temperature divides out again in the weights.
        const double of_fit = statistics::information_criterion(fit->fit.squares(), fit->fit.samples(), effective,
                                                                static_cast<int>(fit->fit.parameters.size()));
        const double of_held_out = statistics::information_criterion(samples * std::pow(fit->*held_out, 2), samples,
                                                                     effective, 0);
        criteria.push_back(0.5 * (of_fit + of_held_out) +
                           (effect_at_bound(fit->fit, policy)
                                ? 2.0 * policy.temperature * std::log(policy.odds_against_bounds)
                                : 0.0));
    }
    return criteria;
}

/// Whether the fit with the lowest criterion has more numbers that a single trial determines than another one: holding
/// out that trial does not test them.
bool is_best_untested(const std::vector<const JudgedFit*>& fits, const std::vector<double>& criteria) {
    int least = std::numeric_limits<int>::max();
    for (const JudgedFit* fit : fits)
        if (fit->usable()) least = std::min(least, fit->single_trial_directions);
    const auto best = std::min_element(criteria.begin(), criteria.end()) - criteria.begin();
    return fits[static_cast<std::size_t>(best)]->single_trial_directions > least;
}

/// Sets the places of all fits. Sets keep theirs unless they are weighed, too.
void weigh(RankedFits& fits, const Baseline& baseline, bool with_sets) {
    std::vector<const JudgedFit*> all{&baseline.declared};
    std::vector<JudgedFit*> own;
    for (Candidate& candidate : fits.candidates)
        if (candidate.judged) own.push_back(&*candidate.judged);
    if (with_sets)
        for (JudgedFit& set : fits.sets) own.push_back(&set);
    all.insert(all.end(), own.begin(), own.end());
    const std::vector<FitWeight> weights = weights_of(baseline.data, all, baseline.policy().judgement);
    fits.declared = weights.front();
    for (std::size_t i = 0; i < own.size(); ++i) {
        own[i]->criterion = weights[i + 1].criterion;
        own[i]->weight = weights[i + 1].weight;
    }
}

}  // namespace

std::vector<FitWeight> weights_of(const FitData& data, const std::vector<const JudgedFit*>& fits,
                                  const JudgementPolicy& policy) {
    std::vector<FitWeight> places(fits.size());
    const JudgedFit* best = nullptr;
    for (const JudgedFit* fit : fits)
        if (fit->usable() && (!best || fit->fit.squares() < best->fit.squares())) best = fit;
    if (!best) return places;
    const auto samples = static_cast<double>(data.layout.size());
    const double effective = statistics::effective_samples(best->fit.residual, data.layout);
    // Fits are compared by held-out trials; if these cannot test the best fit, all are compared by blocks of time.
    std::vector<double> criteria = criteria_of(fits, samples, effective, &JudgedFit::held_out_rms, policy);
    if (is_best_untested(fits, criteria))
        criteria = criteria_of(fits, samples, effective, &JudgedFit::held_out_in_time_rms, policy);
    const std::vector<double> weights = statistics::evidence_weights(criteria, policy.temperature);
    for (std::size_t i = 0; i < fits.size(); ++i) places[i] = {criteria[i], weights[i]};
    return places;
}

double weight_among(const JudgedFit& fit, const std::vector<const JudgedFit*>& others, const JudgementPolicy& policy) {
    std::vector<double> criteria{fit.criterion};
    for (const JudgedFit* other : others) criteria.push_back(other->criterion);
    return statistics::evidence_weights(criteria, policy.temperature).front();
}

double evidence_ratio(const FitData& data, const JudgedFit& fit, const JudgedFit& other,
                      const JudgementPolicy& policy) {
    const std::vector<FitWeight> weights = weights_of(data, {&fit, &other}, policy);
    return weights[1].weight > 0.0 ? weights[0].weight / weights[1].weight : std::numeric_limits<double>::infinity();
}

bool have_same_ids(const std::vector<effect::EffectDeclaration>& a, const std::vector<effect::EffectDeclaration>& b) {
    return std::is_permutation(
        a.begin(), a.end(), b.begin(), b.end(),
        [](const effect::EffectDeclaration& x, const effect::EffectDeclaration& y) { return x.id == y.id; });
}

RankedFits with_ranked_candidates(RankedFits fits, const Baseline& baseline) {
    weigh(fits, baseline, false);
    // Three groups: explains the residual, fitted, not fitted.
    const auto rank = [&](const Candidate& c) { return !c.judged ? 2 : explains(*c.judged, baseline) ? 0 : 1; };
    std::stable_sort(fits.candidates.begin(), fits.candidates.end(), [&](const Candidate& a, const Candidate& b) {
        if (rank(a) != rank(b)) return rank(a) < rank(b);
        if (a.judged) return a.judged->criterion < b.judged->criterion;
        return a.score.share() > b.score.share();
    });
    return fits;
}

RankedFits with_ranked_sets(RankedFits fits, const Baseline& baseline) {
    weigh(fits, baseline, true);
    const auto rank = [&](const JudgedFit& set) { return explains(set, baseline) ? 0 : 1; };
    std::stable_sort(fits.sets.begin(), fits.sets.end(), [&](const JudgedFit& a, const JudgedFit& b) {
        return std::pair(rank(a), a.criterion) < std::pair(rank(b), b.criterion);
    });
    return fits;
}

void enter_fit(RankedFits& fits, JudgedFit fit) {
    if (fit.fit.effects.size() == 1) {
        const std::string id = fit.fit.effects.front().id;
        const auto own = std::find_if(fits.candidates.begin(), fits.candidates.end(),
                                      [&](const Candidate& candidate) { return candidate.score.id == id; });
        if (own != fits.candidates.end() && fit.fit.squares() < left_by(fits.candidates, id))
            own->judged = std::move(fit);
        return;
    }
    const auto same = std::find_if(fits.sets.begin(), fits.sets.end(), [&](const JudgedFit& other) {
        return have_same_ids(other.fit.effects, fit.fit.effects);
    });
    if (same == fits.sets.end())
        fits.sets.push_back(std::move(fit));
    else if (fit.fit.squares() < same->fit.squares())
        *same = std::move(fit);
}

double left_by(const std::vector<Candidate>& candidates, const std::string& effect) {
    for (const Candidate& candidate : candidates)
        if (candidate.score.id == effect && candidate.judged) return candidate.judged->fit.squares();
    return std::numeric_limits<double>::infinity();
}

double min_left(const std::vector<Candidate>& candidates) {
    double least = std::numeric_limits<double>::infinity();
    for (const Candidate& candidate : candidates) least = std::min(least, left_by(candidates, candidate.score.id));
    return least;
}

bool explained(const std::vector<Candidate>& ranked, const Baseline& baseline, Leniency leniency) {
    return !ranked.empty() && ranked.front().judged && explains(*ranked.front().judged, baseline, leniency);
}

}  // namespace myo::diagnosis
