#include "diagnosis/search/search_decisions.hpp"

#include <algorithm>
#include <cassert>

namespace myo::diagnosis {

bool is_worth_correcting(const JudgedFit& fit, const JudgedFit& declared, const SearchPolicy& policy) {
    return !fit.numerics && fit.fit.excess() <= policy.corrected_share * declared.fit.excess();
}

bool is_unpolished(const JudgedFit& fit) {
    return !fit.numerics && (fit.fit.report.jacobians <= 1 || !fit.fit.report.converged());
}

bool is_rival(const Candidate& candidate, double least_squares, const SearchPolicy& policy) {
    return candidate.judged && candidate.judged->fit.squares() <= policy.rival_factor * least_squares;
}

std::size_t starts_worth_fitting(const std::vector<CandidateStart>& starts, const JudgedFit* best,
                                 const JudgedFit& declared, bool explained, const SearchPolicy& policy) {
    // Without a good fit every start may be the right one.
    const bool mostly = best && best->fit.squares() < policy.max_left * declared.fit.squares() &&
                        best->tests.systematic.rms < policy.noise_like;
    if ((!explained && !mostly) || starts.empty()) return starts.size();
    const double worth = policy.min_relative_reduction * starts.front().predicted_reduction;
    std::size_t last = std::min(policy.first_fits, starts.size());
    while (last < starts.size() && starts[last].predicted_reduction > worth) ++last;
    return last;
}

bool is_worth_a_set(const JudgedFit& best, const Baseline& baseline) {
    return !explains(best, baseline) &&
           best.fit.excess() <= baseline.policy().sets.max_left * baseline.declared.fit.excess();
}

const JudgedFit* best_fit(const std::vector<Candidate>& ranked) {
    return !ranked.empty() && ranked.front().judged ? &*ranked.front().judged : nullptr;
}

JudgedFit* best_of_all(RankedFits& ranked) {
    std::vector<Candidate>& candidates = ranked.candidates;
    JudgedFit* const single = !candidates.empty() && candidates.front().judged ? &*candidates.front().judged : nullptr;
    if (ranked.sets.empty()) return single;
    JudgedFit& set = ranked.sets.front();
    return single && single->fit.squares() <= set.fit.squares() ? single : &set;
}

bool is_far_from_explained(const std::vector<Candidate>& ranked, const Baseline& baseline) {
    const JudgedFit* const best = best_fit(ranked);
    return best && !explains(*best, baseline) &&
           best->fit.excess() > baseline.policy().search.corrected_share * baseline.declared.fit.excess();
}

bool is_explained(const RankedFits& fits, const Baseline& baseline) {
    return explained(fits.candidates, baseline) || (!fits.sets.empty() && explains(fits.sets.front(), baseline) &&
                                                    !is_untested(fits.sets.front(), baseline.declared));
}

prediction::ParameterValues without_effect(prediction::ParameterValues values, std::size_t effect) {
    assert(effect < values.effects.size());
    values.effects.erase(values.effects.begin() + static_cast<std::ptrdiff_t>(effect));
    return values;
}

}  // namespace myo::diagnosis
