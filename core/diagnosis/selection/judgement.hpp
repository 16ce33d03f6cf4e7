#pragma once

#include <vector>

#include "diagnosis/diagnosis.hpp"

namespace myo::diagnosis {

/// Tests of what a fit leaves, and how it predicts data it was not fitted to.
JudgedFit judged(const FitData& data, JointFit fit, const DiagnoseSettings& settings);

/// Gives fits of the same data their criteria and weights: the mean of a cross-validated and a Bayesian information
/// criterion, both with the effective number of samples of the best residual among them. Trials are held out; blocks of
/// time are where the best has more numbers than others of which one trial alone tells.
void weigh(const FitData& data, const std::vector<JudgedFit*>& fits, const JudgementPolicy& policy);

/// Weight of a fit beside others alone, by criteria that weigh() gave.
double weight_among(const JudgedFit& fit, const std::vector<const JudgedFit*>& others, const JudgementPolicy& policy);

/// Weighs the declared fit and those of the candidates, and sorts these: first those that explain the residual, then
/// the others, each by criterion: what leaves a part unexplained is not the answer, though it may predict held-out
/// trials better than one with a number that few trials tell of. Those not fitted follow by what their scores promise.
void order_candidates(Diagnosis& diagnosis);

/// Weighs all fits, of single effects and of pairs, and sorts the pairs.
void order_pairs(Diagnosis& diagnosis);

/// How large a systematic residual may be and still be put down to the program itself, in units of the noise.
double numerical_allowance(const FitData& data, const NumericalError& numerics, const JudgementPolicy& policy);

/// A modulus that ends where it may not go on stands in for something else.
bool modulus_at_bound(const JointFit& fit);

/// Whether a number of an effect, other than a place, has gone as far as it may.
bool effect_at_bound(const JointFit& fit);

/// Whether how much there is of each tried effect is told from nothing, its other numbers and the declared ones being
/// free.
bool differs_from_zero(const JointFit& fit, const JudgementPolicy& policy);

/// Whether a fit's effects, whatever they leave, may be an explanation: they are told from nothing, the modulus is
/// within its bounds, and of the squares on held-out data that noise does not make they take half away, of other
/// trials, or of other times where one trial alone tells of their numbers.
bool may_explain(const JudgedFit& fit, const JudgedFit& before, const JudgementPolicy& policy);

/// Whether there is something to explain: a test fired, and what is systematic exceeds the allowance, and is not the
/// measurement's.
bool needs_explanation(const JudgedFit& fit, const FitData& data, const NumericalError& numerics,
                       const JudgementPolicy& policy);

/// Whether what is systematic is so small that another simulator of the same model may make it, or the mesh, of whose
/// error it is a part: where no effect takes most of it away, nothing is missing.
bool is_faint(const JudgedFit& fit, const FitData& data, const NumericalError& numerics, const JudgementPolicy& policy);

/// Squares that a candidate's fit leaves, and the least of all; infinite where none was fitted.
double left_by(const Diagnosis& diagnosis, const std::string& effect);
double least_left(const Diagnosis& diagnosis);

/// What a fit may leave: for a verdict half as much again as was found of the mesh's error, and a share of what was
/// there, which another form of the effect makes, beyond what chance may add; to end the search none of these.
enum class Leniency { generous, strict };

/// Whether a fit explains what another left: what remains is of the size of the program's own errors, or a small part
/// of what was there.
bool explains(const JudgedFit& fit, const JudgedFit& before, const FitData& data, const NumericalError& numerics,
              const JudgementPolicy& policy, Leniency leniency = Leniency::generous);

/// Whether the first of the candidates does.
bool explained(const Diagnosis& diagnosis, Leniency leniency = Leniency::generous);

}  // namespace myo::diagnosis
