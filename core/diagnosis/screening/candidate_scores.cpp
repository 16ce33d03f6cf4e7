#include "diagnosis/screening/candidate_scores.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "prediction/predict_trials.hpp"

namespace myo::diagnosis {
namespace {

/// Indices of the scores by decreasing explained share; equal ones keep their order.
std::vector<std::size_t> by_share(const std::vector<EffectScore>& scores) {
    std::vector<std::size_t> order(scores.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return scores[a].share() > scores[b].share(); });
    return order;
}

}  // namespace

std::vector<EffectScore> score_with_longer_steps(const setup::Setup& setup, const FitData& data, const JointFit& base,
                                                 const EffectFilter& allowed, ProbeSize size,
                                                 const ScreeningPolicy& policy, const Progress& progress) {
    setup::Setup longer = setup;
    for (setup::PreparedTrial& trial : longer.trials) trial.options.h_s *= 2.0;
    // One run of the fit with the longer steps is both the test of these steps and the reference of the probes.
    const std::vector<prediction::TrialPrediction> unaffected = prediction::predict_trials_with(longer, base.values,
                                                                                                data.trials, progress);
    if (progress.cancelled()) return {};
    if (prediction::all_ok(unaffected) &&
        (flat_residual(data, unaffected) - base.residual).norm() < policy.step_error_share * base.residual.norm())
        return score_effects(longer, data, base, unaffected, allowed, size, policy, progress);
    return score_effects(setup, data, base, base.predictions, allowed, size, policy, progress);
}

EffectScore best_score(const std::vector<EffectScore>& scores) {
    const auto best = std::min_element(scores.begin(), scores.end(),
                                       [](const EffectScore& a, const EffectScore& b) { return a.left < b.left; });
    return best == scores.end() ? EffectScore{} : *best;
}

std::vector<std::size_t> best_probes(const std::vector<EffectScore>& scores, int count, const ScreeningPolicy& policy) {
    std::vector<std::size_t> chosen;
    // Effects of which a probe was chosen.
    std::set<std::string> there;
    for (const std::size_t i : by_share(scores))
        if (static_cast<int>(chosen.size()) < count && scores[i].share() > policy.min_explained &&
            there.insert(scores[i].id).second)
            chosen.push_back(i);
    return chosen;
}

std::vector<std::size_t> other_places(const std::vector<EffectScore>& scores, const EffectFilter& wanted,
                                      const ScreeningPolicy& policy) {
    std::vector<std::size_t> chosen;
    struct Found {
        double best = 0.0;
        int further = 0;
    };
    std::map<std::string, Found> found;
    for (const std::size_t i : by_share(scores)) {
        // By decreasing share the first probe of an effect is its best one, which best_probes() has chosen already.
        const auto [place, is_best] = found.try_emplace(scores[i].id, Found{scores[i].share()});
        Found& effect = place->second;
        if (is_best || !wanted(scores[i].id) ||
            scores[i].share() < std::max(policy.min_explained, policy.comparable_place * effect.best))
            continue;
        if (effect.further++ < policy.max_places && chosen.size() < policy.max_places_of_all) chosen.push_back(i);
    }
    return chosen;
}

}  // namespace myo::diagnosis
