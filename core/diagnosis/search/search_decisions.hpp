#pragma once

#include <vector>

#include "diagnosis/fit/candidate_fits.hpp"
#include "diagnosis/selection/ranking.hpp"

namespace myo::diagnosis {

/// Whether a fit has a motion so much nearer to the truth than the declared one that its own numerical error is
/// computed.
bool is_worth_correcting(const JudgedFit& fit, const JudgedFit& declared, const SearchPolicy& policy);

/// Whether a fit used secants or few evaluations, so that it is continued with new derivatives. Not if its own
/// numerical error was removed: that ended with a fit.
bool is_unpolished(const JudgedFit& fit);

/// Whether a fitted candidate comes close to the smallest squared residual.
bool is_rival(const Candidate& candidate, double least_squares, const SearchPolicy& policy);

/// Number of starts, counted from the first, that are fitted. Once a fit explains the residual, or removes most of its
/// squares and leaves a systematic part below the noise: the first fits, and those that follow with a predicted
/// reduction that is a share of the first one's. Otherwise all.
/// @param starts     by decreasing predicted reduction
/// @param best       fit of the most credible candidate; null: none was fitted
/// @param explained  it explains the residual
std::size_t starts_worth_fitting(const std::vector<CandidateStart>& starts, const JudgedFit* best,
                                 const JudgedFit& declared, bool explained, const SearchPolicy& policy);

/// Whether further effects are fitted together with the best one: it leaves an excess that needs an explanation, but
/// removes a share of that of the declared fit.
bool is_worth_a_set(const JudgedFit& best, const Baseline& baseline);

/// Fit of the most credible candidate; null if none was fitted.
const JudgedFit* best_fit(const std::vector<Candidate>& ranked);

/// The better one of the most credible candidate and the most credible set, by what they leave; null if none was
/// fitted.
JudgedFit* best_of_all(RankedFits& ranked);

/// Whether even the best single effect leaves so much that another start of one effect hardly explains the residual:
/// sets of effects are tried before the other starts.
bool is_far_from_explained(const std::vector<Candidate>& ranked, const Baseline& baseline);

/// Whether a single effect, or a set that other trials test, explains the residual.
bool is_explained(const RankedFits& fits, const Baseline& baseline);

/// Values without one of their effects.
/// @param effect  index in values.effects (asserted)
prediction::ParameterValues without_effect(prediction::ParameterValues values, std::size_t effect);

}  // namespace myo::diagnosis
