#include "diagnosis/search/search_pairs.hpp"

#include <utility>

#include "diagnosis/fit/candidate_fits.hpp"
#include "diagnosis/fit/stored_fit.hpp"
#include "diagnosis/screening/candidate_scores.hpp"
#include "diagnosis/screening/screen_effects.hpp"
#include "diagnosis/search/search_decisions.hpp"
#include "prediction/predict_trials.hpp"

namespace myo::diagnosis {
namespace {

constexpr const char* fit_phase = "refit of pairs";

/// Fits of a second effect with the first one.
/// @param data  with the shift of the first effect's fit
/// @return      empty if cancelled
std::vector<JudgedFit> fit_pairs(const DiagnosisContext& context, const FitData& data, const JointFit& first,
                                 double least_so_far, FitStore& store, PhaseLog& log) {
    JointFit base = first;
    base.predictions = prediction::predict_trials_with(context.setup, base.values, data.trials, log.progress());
    if (log.cancelled()) return {};
    const std::vector<EffectScore> scores = log.timed("score of pairs", 0, [&] {
        return scores_from(context, data, base, ProbeSize::small, log, first.effects.front().id);
    });
    if (log.cancelled()) return {};
    std::vector<CandidateStart> starts;
    for (const std::size_t i : best_probes(scores, context.settings.pairs, context.policy().screening))
        starts.push_back(start_of(scores[i]));
    return fit_candidates({context.setup, data, context.settings, base, starts, least_so_far,
                           context.policy().pairs.pruning_factor, fit_phase},
                          store, log);
}

/// The ranked fits after a refit of one effect of a pair alone, from its values in the pair.
RankedFits with_refit_alone(const DiagnosisContext& context, const FitData& data, RankedFits fits,
                            const JudgedFit& pair, std::size_t kept, FitStore& store, PhaseLog& log) {
    const Baseline baseline = context.baseline();
    if (log.cancelled() || explained(fits.candidates, baseline)) return fits;
    const prediction::ParameterValues start = with_one_effect(pair.fit.values, context.setup.experiment.effects.size(),
                                                              kept);
    JointFit alone = logged_fit(
        fit_phase, {context.setup, data, start, context.policy(), EffectFreedom::all, context.policy().search.polish},
        store, log);
    if (log.cancelled() || !alone.usable()) return fits;
    const std::string id = pair.fit.effects[kept].id;
    for (Candidate& candidate : fits.candidates)
        if (candidate.score.id == id && alone.squares() < left_by(fits.candidates, id)) {
            candidate.judged = judged(data, std::move(alone), context.settings);
            break;
        }
    return with_ranked_candidates(std::move(fits), baseline);
}

}  // namespace

PairSearch search_pairs(const DiagnosisContext& context, RankedFits singles, FitStore& store, PhaseLog& log) {
    PairSearch result{std::move(singles), context.data.shift};
    RankedFits& fits = result.fits;
    const Baseline baseline = context.baseline();
    if (fits.candidates.empty() || !fits.candidates.front().judged ||
        !is_worth_a_pair(*fits.candidates.front().judged, baseline))
        return result;
    const JudgedFit& first = *fits.candidates.front().judged;
    if (first.numerics) result.shift = first.numerics->shift;
    FitData data = context.data;
    data.shift = result.shift;
    std::vector<JudgedFit> pairs = fit_pairs(context, data, first.fit, min_left(fits.candidates), store, log);
    if (log.cancelled()) return result;
    for (JudgedFit& pair : pairs)
        if (pair.usable()) fits.pairs.push_back(std::move(pair));
    fits = with_ranked_pairs(std::move(fits), baseline);
    if (fits.pairs.empty()) return result;
    const JudgedFit best = fits.pairs.front();
    for (const std::size_t kept : {1u, 0u})
        fits = with_refit_alone(context, data, std::move(fits), best, kept, store, log);
    fits = with_ranked_pairs(std::move(fits), baseline);
    return result;
}

}  // namespace myo::diagnosis
