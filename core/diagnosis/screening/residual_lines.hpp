#pragma once

#include <Eigen/Core>

#include <vector>

#include "statistics/residual_layout.hpp"

namespace myo::diagnosis {

/// Frequencies at which the spectra of the residuals have their highest peaks [Hz], over all trials, strongest first.
///
/// A peak is a local maximum of a trial's mean spectrum with at least one and a half cycles in the trial, refined by a
/// parabola through its logarithm. Of peaks nearer to each other than the trials resolve, the strongest counts.
///
/// @param r      residuals over their standard deviations
/// @param count  most that are returned
std::vector<double> residual_lines(const Eigen::VectorXd& r, const statistics::ResidualLayout& layout,
                                   std::size_t count);

}  // namespace myo::diagnosis
