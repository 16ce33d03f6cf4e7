#include "diagnosis/screening/screen_effects.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "diagnosis/fit/stored_fit.hpp"
#include "diagnosis/screening/candidate_scores.hpp"
#include "diagnosis/screening/debiased_start.hpp"
#include "statistics/score_test.hpp"

namespace myo::diagnosis {
namespace {

constexpr const char* score_phase = "score";

/// Declared fit with its distorted parameters reset; empty if none is distorted, or if the fit is not usable.
std::optional<JointFit> debiased_fit(const DiagnosisContext& context, FitStore& store, const PhaseLog& log) {
    const std::optional<prediction::ParameterValues> values = debiased_start(
        context.declared.fit, prediction::declared_values(context.setup), context.policy().declared);
    if (!values) return std::nullopt;
    // One evaluation: the values stay, only residual and Jacobian are computed there.
    JointFit fit = stored_fit({context.setup, context.data, *values, context.policy(), EffectFreedom::all, {1}}, store,
                              log.progress());
    return fit.usable() ? std::optional(std::move(fit)) : std::nullopt;
}

}  // namespace

Screening screen_effects(const DiagnosisContext& context, FitStore& store, PhaseLog& log) {
    Screening screening = log.timed(score_phase, 2 * context.fit_count(), [&] {
        Screening first{debiased_fit(context, store, log), {}};
        first.scores = scores_from(context, context.data, first.base(context), ProbeSize::small, log);
        return first;
    });
    if (log.cancelled() || !screening.debiased ||
        best_score(screening.scores).test.explained >= context.policy().search.conclusive_score)
        return screening;
    // The distorted values may be right, or the reset values no better: also score from the declared fit.
    Screening other{std::nullopt, log.timed(score_phase, context.fit_count(), [&] {
                        return scores_from(context, context.data, context.declared.fit, ProbeSize::small, log);
                    })};
    if (log.cancelled()) return screening;
    return best_score(other.scores).left >= best_score(screening.scores).left ? screening : other;
}

std::vector<EffectScore> scores_from(const DiagnosisContext& context, const FitData& data, const JointFit& base,
                                     ProbeSize size, const PhaseLog& log, const std::vector<std::string>& without) {
    return score_with_longer_steps(
        context.setup, data, base,
        [&](const std::string& id) {
            return std::find(without.begin(), without.end(), id) == without.end() && may_be_named(context.settings, id);
        },
        size, context.policy().screening, log.progress());
}

std::vector<Candidate> listed_candidates(const std::vector<EffectScore>& scores) {
    std::vector<double> p;
    for (const EffectScore& score : scores) p.push_back(score.usable() ? score.test.p : 1.0);
    const std::vector<double> adjusted = statistics::holm_adjusted(p);
    // Adjusted over all probes, not effects: an effect with many probes has more chances to explain by chance.
    std::map<std::string, std::size_t> best_probe;
    for (std::size_t i = 0; i < scores.size(); ++i) {
        const auto [place, first] = best_probe.emplace(scores[i].id, i);
        if (!first && scores[i].share() > scores[place->second].share()) place->second = i;
    }
    std::vector<Candidate> candidates;
    for (const auto& [id, i] : best_probe) candidates.push_back({scores[i], adjusted[i], {}, {}});
    return candidates;
}

}  // namespace myo::diagnosis
