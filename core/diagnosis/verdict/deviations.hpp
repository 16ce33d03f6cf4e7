#pragma once

#include <optional>

#include "diagnosis/selection/judged_fit.hpp"

namespace myo::diagnosis {

/// The fit with standard deviations of its numbers that hold for the errors that residuals have: the variance of the
/// estimate under the autocorrelation of what the fit leaves (sandwich estimator, White 1980, Econometrica 48, 817;
/// Bartlett 1935), and the shift of the estimate by what may be wrong in the removed errors of mesh and step, to first
/// order: all of them where a force has a corner, see effect::Effect::has_corner. Undetermined numbers keep NaN.
/// @param numerics  error that was removed from the fit's predictions
JudgedFit with_deviations(JudgedFit fit, const FitData& data, const NumericalError& numerics,
                          const NumericsPolicy& policy);

/// Limits of a number, in its own unit.
struct Interval {
    double low = 0.0, high = 0.0;
};

/// 95 % interval from a standard deviation, within the bounds of the parameter; of the logarithm for a parameter over
/// decades. Empty if the deviation is not finite.
std::optional<Interval> interval_95(const inverse::Parameter& parameter, double value, double deviation);

}  // namespace myo::diagnosis
