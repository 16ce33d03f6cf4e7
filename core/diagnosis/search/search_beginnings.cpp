#include "diagnosis/search/search_beginnings.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "diagnosis/discretisation/correct_discretisation.hpp"
#include "diagnosis/fit/candidate_fits.hpp"
#include "diagnosis/fit/stored_fit.hpp"
#include "diagnosis/screening/candidate_scores.hpp"
#include "diagnosis/screening/screen_effects.hpp"
#include "diagnosis/search/beginning_context.hpp"
#include "diagnosis/search/search_decisions.hpp"
#include "diagnosis/search/search_sets.hpp"

namespace myo::diagnosis {
namespace {

constexpr const char* phase = "fit of beginnings";

/// The fits with weights, in the order of both candidates and sets.
RankedFits ranked(RankedFits fits, const Baseline& baseline) {
    return with_ranked_sets(with_ranked_candidates(std::move(fits), baseline), baseline);
}

/// Fits of the most likely single effects.
RankedFits fit_singles(const DiagnosisContext& context, FitStore& store, PhaseLog& log) {
    const Screening screening = screen_effects(context, store, log);
    RankedFits fits;
    if (log.cancelled()) return fits;
    fits.candidates = listed_candidates(screening.scores);
    std::vector<CandidateStart> starts;
    for (const std::size_t i : best_probes(screening.scores, context.settings.refits, context.policy().screening))
        starts.push_back(start_of(screening.scores[i]));
    const JointFit& base = screening.base(context);
    for (JudgedFit& fit : fit_candidates({context.setup, context.data, context.settings, base, starts, base.squares(),
                                          context.policy().search.pruning_factor, phase},
                                         store, log))
        if (fit.usable()) enter_fit(fits, std::move(fit));
    return ranked(std::move(fits), context.baseline());
}

/// Values of the best fits, those that explain the residual first.
std::vector<prediction::ParameterValues> best_values(const RankedFits& fits, const Baseline& baseline) {
    std::vector<const JudgedFit*> all;
    for (const Candidate& candidate : fits.candidates)
        if (candidate.judged && candidate.judged->usable()) all.push_back(&*candidate.judged);
    for (const JudgedFit& set : fits.sets)
        if (set.usable()) all.push_back(&set);
    std::stable_sort(all.begin(), all.end(), [&](const JudgedFit* a, const JudgedFit* b) {
        return std::pair(!explains(*a, baseline), a->criterion) < std::pair(!explains(*b, baseline), b->criterion);
    });
    const BeginningPolicy& policy = baseline.policy().beginnings;
    std::vector<prediction::ParameterValues> values;
    // Fits far behind the first lead the longer beginning to a wrong minimum at the cost of a fit each.
    for (const JudgedFit* fit : all)
        if (values.size() < policy.kept && fit->fit.squares() <= policy.kept_factor * all.front()->fit.squares())
            values.push_back(fit->fit.values);
    return values;
}

/// Fits from the values of a shorter beginning.
RankedFits refitted(const DiagnosisContext& context, const std::vector<prediction::ParameterValues>& starts,
                    RankedFits fits, FitStore& store, PhaseLog& log) {
    for (const prediction::ParameterValues& start : starts) {
        JointFit fit = logged_fit(phase,
                                  {context.setup, context.data, start, context.policy(), EffectFreedom::all,
                                   context.policy().beginnings.refit},
                                  store, log);
        if (log.cancelled()) return fits;
        if (fit.usable()) enter_fit(fits, judged(context.data, std::move(fit), context.settings));
    }
    return ranked(std::move(fits), context.baseline());
}

/// The fits, the best of them without the numerical error of its own motion, if that may be what it leaves.
RankedFits corrected(const DiagnosisContext& context, RankedFits fits, Leniency leniency, FitStore& store,
                     PhaseLog& log) {
    JudgedFit* const best = best_of_all(fits);
    if (log.cancelled() || !best || explains(*best, context.baseline(), leniency) ||
        !is_worth_correcting(*best, context.declared, context.policy().search))
        return fits;
    std::optional<JudgedFit> own = correct_discretisation(
        {context.setup, context.data, context.settings, context.refinement, phase, context.policy().search.correction},
        *best, store, log);
    if (!own) return fits;
    *best = std::move(*own);
    return ranked(std::move(fits), context.baseline());
}

/// The fits with those of sets, if nothing explains the residual.
RankedFits with_sets(const DiagnosisContext& context, RankedFits fits, FitStore& store, PhaseLog& log) {
    fits = corrected(context, std::move(fits), Leniency::tolerant, store, log);
    if (log.cancelled() || is_explained(fits, context.baseline())) return fits;
    // Exchanges are left to the whole recordings: one asks for as many fits as the growth by an effect, per effect.
    return search_sets(context, std::move(fits), store, log, {}, SetSearchExtent::grown).fits;
}

/// Values of the best fits of the longest beginning that was searched; enters the scores. Empty if a beginning cannot
/// be fitted.
std::vector<prediction::ParameterValues> starts_from_beginnings(const DiagnosisContext& context,
                                                                BeginningSearch& search, FitStore& store,
                                                                PhaseLog& log) {
    const BeginningPolicy& policy = context.policy().beginnings;
    // What beginnings lead to counts only once it is fitted to the whole recordings.
    const PhaseLimit limit(log, share_of_rest(log.progress(), policy.share_of_time));
    std::vector<prediction::ParameterValues> starts;
    for (double share = search.share; share < 1.0 && !log.cancelled(); share *= policy.growth) {
        const std::optional<DiagnosisContext> part = beginning_context(context, share, store, log);
        if (log.cancelled()) break;
        if (!part) return {};
        RankedFits fits = starts.empty() ? fit_singles(*part, store, log)
                                         : refitted(*part, starts, std::move(search.fits), store, log);
        fits = with_sets(*part, std::move(fits), store, log);
        if (std::vector<prediction::ParameterValues> best = best_values(fits, part->baseline()); !best.empty())
            starts = std::move(best);
        // Fits of different beginnings are not comparable: only the scores of the candidates are kept.
        search.fits = {{}, std::move(fits.candidates), {}};
        for (Candidate& candidate : search.fits.candidates) candidate.judged.reset();
    }
    search.cut = limit.passed();
    return starts;
}

}  // namespace

BeginningSearch search_beginnings(const DiagnosisContext& context, FitStore& store, PhaseLog& log) {
    const BeginningPolicy& policy = context.policy().beginnings;
    if (context.declared.tests.systematic.rms < policy.min_residual) return {};
    double share = policy.first_share;
    // A beginning in which the residual is small does not show the effect.
    while (share < 1.0 && residual_in_beginnings(context, share) < policy.min_residual) share *= policy.growth;
    BeginningSearch search{{}, share, false};
    const std::vector<prediction::ParameterValues> starts = starts_from_beginnings(context, search, store, log);
    if (starts.empty()) return {};
    search.fits = refitted(context, starts, std::move(search.fits), store, log);
    search.fits = corrected(context, std::move(search.fits), Leniency::strict, store, log);
    return search;
}

}  // namespace myo::diagnosis
