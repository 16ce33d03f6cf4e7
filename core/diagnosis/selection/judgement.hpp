#pragma once

#include "diagnosis/selection/judged_fit.hpp"

namespace myo::diagnosis {

/// Largest systematic residual that may be due to numerical error [noise levels].
/// The uncertainty of the extrapolation, at least min_systematic, and more if little of the mesh error is left.
double numerical_allowance(const FitData& data, const NumericalError& numerics, const JudgementPolicy& policy);

/// Whether the fitted modulus is at a bound; it then compensates for something else.
bool modulus_at_bound(const JointFit& fit, const JudgementPolicy& policy);

/// Whether a scalar number of an effect is at a bound; components of vectors, such as places, are not tested.
bool effect_at_bound(const JointFit& fit, const JudgementPolicy& policy);

/// Whether the amount of every tried effect differs significantly from zero, with all other numbers of the fit free.
/// Amounts that the data do not determine do not. True if the fit has no deviations.
bool differs_from_zero(const JointFit& fit, const JudgementPolicy& policy);

/// Whether a fit is a possible explanation of the residual of the declared fit: its modulus is within its bounds, its
/// effects differ from zero, and they predict held-out data better than the declared fit does.
bool may_explain(const JudgedFit& fit, const Baseline& baseline);

/// Whether the residual of the declared fit needs an explanation: it is significant, it is not measurement drift, and
/// its systematic part exceeds numerical_allowance().
bool needs_explanation(const Baseline& baseline);

/// Whether the systematic residual of the declared fit is so small that another simulator of the same model, or a part
/// of the mesh error, may cause it. If no effect removes most of it, nothing is missing.
bool is_faint(const Baseline& baseline);

/// Tolerance for the systematic residual that a fit leaves. tolerant, for the verdict:
/// JudgementPolicy::mesh_error_factor times the estimated mesh error, and a share of the original residual for another
/// form of the effect, beyond chance. strict, to end the search: none of these.
enum class Leniency { tolerant, strict };

/// Whether a fit explains the residual of the declared fit: may_explain() holds, the systematic part falls by the
/// required share, and what remains is not significant, measurement drift, or within the tolerance.
bool explains(const JudgedFit& fit, const Baseline& baseline, Leniency leniency = Leniency::tolerant);

/// Whether a single trial determines some numbers of a set, so that no other trial tests them. False for sets with an
/// effect that acts in one trial only: other trials cannot test it. A single effect is tested by the residual itself.
bool is_untested(const JudgedFit& set, const JudgedFit& declared);

}  // namespace myo::diagnosis
