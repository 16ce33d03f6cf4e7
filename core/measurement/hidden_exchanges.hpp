#pragma once

#include <Eigen/Core>

#include <vector>

#include "measurement/exchanges.hpp"

namespace myo::measurement {

/// Restores names that two markers exchanged while both were hidden, where put_back_exchanges() cannot tell: the body
/// moved too far in the gap for a comparison of relative positions.
///
/// After every common gap the hypothesis "exchanged from here on", up to the end, to another common gap, or to a sample
/// at which the names are visibly exchanged, is compared with the recording as it is: by the residuals of both markers
/// in a fit to the other markers, see MarkerPredictor. The exchange is restored if it reduces them to a quarter.
///
/// @param tracks   in/out, one per marker, 3 x T [m], NaN where occluded; two others must be visible
/// @param sigma_m  per marker, standard deviation of the noise per coordinate; 0 if unknown
/// @return         the exchanges that were reversed, in order of time
std::vector<Exchange> put_back_hidden_exchanges(std::vector<Eigen::Matrix3Xd>& tracks, const Eigen::VectorXd& sigma_m);

}  // namespace myo::measurement
