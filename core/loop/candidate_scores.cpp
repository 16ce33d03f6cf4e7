#include "loop/candidate_scores.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "project/predict_trials.hpp"

namespace myo {
namespace {

/// Longer steps may change the predictions by this share of the residual.
constexpr double step_in_scores = 0.3;
/// A probe that takes away less of the residual is not worth a fit.
constexpr double least_explained = 0.02;

}  // namespace

std::vector<EffectScore> score_coarsely(const Study& study, const FitData& data, const JointFit& base, const EffectFilter& allowed, ProbeSize size, const Progress& progress) {
    Study longer = study;
    for (StudyTrial& trial : longer.trials) trial.options.h_s *= 2.0;
    const std::vector<TrialPrediction> unaffected = predict_trials_with(longer, base.values, data.trials, progress);
    if (progress.cancelled()) return {};
    if (all_ok(unaffected) && (flat_residual(data, unaffected) - base.residual).norm() < step_in_scores * base.residual.norm())
        return score_effects(longer, data, base, unaffected, allowed, size, progress);
    return score_effects(study, data, base, base.predictions, allowed, size, progress);
}

EffectScore best_score(const std::vector<EffectScore>& scores) {
    const auto best = std::min_element(scores.begin(), scores.end(), [](const EffectScore& a, const EffectScore& b) { return a.left < b.left; });
    return best == scores.end() ? EffectScore{} : *best;
}

std::vector<std::size_t> worth_fitting(const std::vector<EffectScore>& scores, int count) {
    std::vector<std::size_t> order(scores.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return scores[a].share() > scores[b].share(); });
    std::vector<std::size_t> chosen;
    std::map<std::string, int> times;
    for (const std::size_t i : order)
        if (static_cast<int>(chosen.size()) < count && scores[i].share() > least_explained && times[scores[i].id]++ == 0) chosen.push_back(i);
    return chosen;
}

}  // namespace myo
