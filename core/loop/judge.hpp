#pragma once

#include <vector>

#include "loop/diagnosis.hpp"

namespace myo {

/// What leaves a larger share of what was there before explains little, however doubtful the mesh; nor does a second effect that does.
inline constexpr double most_of_what_was = 0.6;

/// Tests of what a fit leaves, and how it predicts data it was not fitted to.
JudgedFit judged(const FitData& data, JointFit fit, const DiagnoseSettings& settings);

/// Gives fits of the same data their criteria and weights: the mean of a cross-validated and a Bayesian information criterion, both with the
/// effective number of samples of the best residual among them. Trials are held out; blocks of time are where the best has more numbers than
/// others of which one trial alone tells.
void weigh(const FitData& data, const std::vector<JudgedFit*>& fits);

/// Weighs the declared fit and those of the candidates, and sorts these, the best first; those not fitted follow by what their scores promise.
void order_candidates(Diagnosis& diagnosis);

/// Weighs all fits, of single effects and of pairs, and sorts the pairs.
void order_pairs(Diagnosis& diagnosis);

/// How large a systematic residual may be and still be put down to the program itself, in units of the noise.
double numerical_allowance(const FitData& data, const NumericalError& numerics);

/// A modulus that ends where it may not go on stands in for something else.
bool modulus_at_bound(const JointFit& fit);

/// Whether a number of an effect, other than a place, has gone as far as it may.
bool effect_at_bound(const JointFit& fit);

/// Whether there is something to explain: a test fired, and what is systematic exceeds the allowance.
bool needs_explanation(const JudgedFit& fit, const FitData& data, const NumericalError& numerics);

/// Whether what is systematic is so small that another simulator of the same model may make it: where no effect takes most of it away, nothing is missing.
bool is_faint(const JudgedFit& fit);

/// How much of what a fit leaves is put down to the mesh: half as much again as was found, for a verdict, or that alone, to end the search.
enum class MeshDoubt { generous, strict };

/// Whether a fit explains what another left: what remains is of the size of the program's own errors, or a small part of what was there.
bool explains(const JudgedFit& fit, const JudgedFit& before, const FitData& data, const NumericalError& numerics, MeshDoubt mesh = MeshDoubt::generous);

}  // namespace myo
