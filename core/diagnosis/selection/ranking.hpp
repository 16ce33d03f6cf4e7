#pragma once

#include <string>
#include <vector>

#include "diagnosis/selection/judgement.hpp"

namespace myo::diagnosis {

/// Place of a fit among others.
struct FitWeight {
    double criterion = 0.0;  // order of fits; lower is better
    double weight = 0.0;     // share of the evidence
};

/// Criteria and weights of fits of the same data, in their order.
///
/// The criterion is the mean of a cross-validated and a Bayesian information criterion, both with the effective number
/// of samples of the best residual, and a penalty for effects at a bound. Trials are held out, or blocks of time if a
/// single trial determines more numbers of the best fit than of another. Fits that are not usable have an infinite
/// criterion and no weight; if none is usable, all are 0.
std::vector<FitWeight> weights_of(const FitData& data, const std::vector<const JudgedFit*>& fits,
                                  const JudgementPolicy& policy);

/// Weight of a fit compared with the given others only, from the criteria of all of them.
double weight_among(const JudgedFit& fit, const std::vector<const JudgedFit*>& others, const JudgementPolicy& policy);

/// Weight of a fit over that of another one, compared by themselves; infinite if the other has none.
double evidence_ratio(const FitData& data, const JudgedFit& fit, const JudgedFit& other, const JudgementPolicy& policy);

/// Whether the same effects act in two sets, in any order.
bool have_same_ids(const std::vector<effect::EffectDeclaration>& a, const std::vector<effect::EffectDeclaration>& b);

/// Fits of single effects and of sets of two and more, with their weights.
struct RankedFits {
    FitWeight declared;                 // of the declared fit
    std::vector<Candidate> candidates;  // most credible first
    std::vector<JudgedFit> sets;        // of two and more effects, best first
};

/// Weighs the fits of the declared model and of the candidates, and sorts the candidates: first those that explain the
/// residual, then the other fits, each by criterion; then those not fitted, by score. A fit that leaves a part
/// unexplained ranks lower even if it predicts held-out trials better than one with a number that few trials determine.
RankedFits with_ranked_candidates(RankedFits fits, const Baseline& baseline);

/// Weighs all fits, of the declared model, of single effects and of sets, and sorts the sets: first those that explain
/// the residual, each group by criterion.
RankedFits with_ranked_sets(RankedFits fits, const Baseline& baseline);

/// Enters a fit among those of its effects, where it replaces a worse one.
/// A single effect that is not among the candidates is dropped.
void enter_fit(RankedFits& fits, JudgedFit fit);

/// Squared residual of an effect's fit; infinite if it was not fitted.
double left_by(const std::vector<Candidate>& candidates, const std::string& effect);
/// Smallest squared residual of all candidates' fits; infinite if none was fitted.
double min_left(const std::vector<Candidate>& candidates);

/// explains() for the first candidate; false if it was not fitted.
bool explained(const std::vector<Candidate>& ranked, const Baseline& baseline, Leniency leniency = Leniency::tolerant);

}  // namespace myo::diagnosis
