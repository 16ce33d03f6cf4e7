#pragma once

#include <vector>

#include "diagnosis/diagnosis.hpp"

namespace myo::diagnosis {

/// Assesses a fit: tests of its residual and prediction of held-out data.
JudgedFit judged(const FitData& data, JointFit fit, const DiagnoseSettings& settings);

/// Sets criterion and weight of fits of the same data. The criterion is the mean of a cross-validated and a Bayesian
/// information criterion, both with the effective number of samples of the best residual, and a penalty for effects at
/// a bound. Trials are held out, or blocks of time if a single trial determines more numbers of the best fit than
/// of another.
void weigh(const FitData& data, const std::vector<JudgedFit*>& fits, const JudgementPolicy& policy);

/// Weight of a fit compared with the given others only, from the criteria that weigh() has set.
double weight_among(const JudgedFit& fit, const std::vector<const JudgedFit*>& others, const JudgementPolicy& policy);

/// Weighs the fits of the declared model and of the candidates, and sorts the candidates: first those that explain the
/// residual, then the other fits, each by criterion; then those not fitted, by score. A fit that leaves a part
/// unexplained ranks lower even if it predicts held-out trials better than one with a number that few trials determine.
void order_candidates(Diagnosis& diagnosis);

/// Weighs all fits, of single effects and of pairs, and sorts the pairs by criterion.
void order_pairs(Diagnosis& diagnosis);

/// Largest systematic residual that may be due to numerical error [noise levels].
double numerical_allowance(const FitData& data, const NumericalError& numerics, const JudgementPolicy& policy);

/// Whether the fitted modulus is at a bound; it then compensates for something else.
bool modulus_at_bound(const JointFit& fit);

/// Whether a scalar number of an effect is at a bound; components of vectors, such as places, are not tested.
bool effect_at_bound(const JointFit& fit);

/// Whether the amount of every tried effect differs significantly from zero, with all other numbers of the fit free.
bool differs_from_zero(const JointFit& fit, const JudgementPolicy& policy);

/// Whether the effects of a fit may be an explanation, whatever they leave: their amounts differ from zero, the modulus
/// is within its bounds, and they remove at least half of the excess squares on held-out data (other trials, or other
/// blocks of time if a single trial determines some of their numbers).
bool may_explain(const JudgedFit& fit, const JudgedFit& before, const JudgementPolicy& policy);

/// Whether a residual needs an explanation: it is significant, it is not measurement drift, and its systematic part
/// exceeds numerical_allowance().
bool needs_explanation(const JudgedFit& fit, const FitData& data, const NumericalError& numerics,
                       const JudgementPolicy& policy);

/// Whether the systematic residual is so small that another simulator of the same model, or a part of the mesh error,
/// may cause it. If no effect removes most of it, nothing is missing.
bool is_faint(const JudgedFit& fit, const FitData& data, const NumericalError& numerics, const JudgementPolicy& policy);

/// Squared residual of an effect's fit; infinite if it was not fitted.
double left_by(const Diagnosis& diagnosis, const std::string& effect);
/// Smallest squared residual of all candidates' fits; infinite if none was fitted.
double least_left(const Diagnosis& diagnosis);

/// Tolerance for the systematic residual that a fit leaves. generous, for the verdict: one and a half times the
/// estimated mesh error, and a share of the original residual for another form of the effect, beyond chance. strict, to
/// end the search: none of these.
enum class Leniency { generous, strict };

/// Whether a fit explains the residual that `before` left: may_explain() holds, the systematic part falls by the
/// required share, and what remains is not significant, measurement drift, or within the tolerance.
bool explains(const JudgedFit& fit, const JudgedFit& before, const FitData& data, const NumericalError& numerics,
              const JudgementPolicy& policy, Leniency leniency = Leniency::generous);

/// explains() for the first candidate; false if it was not fitted.
bool explained(const Diagnosis& diagnosis, Leniency leniency = Leniency::generous);

}  // namespace myo::diagnosis
