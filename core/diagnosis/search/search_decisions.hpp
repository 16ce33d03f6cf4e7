#pragma once

#include <vector>

#include "diagnosis/fit/candidate_fits.hpp"
#include "diagnosis/selection/judgement.hpp"

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

/// Whether a second effect is fitted together with the best one: it leaves an excess that needs an explanation, but
/// removes a share of that of the declared fit.
bool is_worth_a_pair(const JudgedFit& best, const Baseline& baseline);

/// Values of a pair with one of its effects removed.
/// @param declared_effects  number of effects of the experiment, which precede those of the pair
/// @param kept              0: the first effect of the pair is kept, 1: the second
prediction::ParameterValues with_one_effect(prediction::ParameterValues pair, std::size_t declared_effects,
                                            std::size_t kept);

}  // namespace myo::diagnosis
