#pragma once

#include <vector>

#include "model/force_element.hpp"

namespace myo::model {

/// Springs without length that pull nodes to places, as a hand that holds a patch of the body: energy sum of
/// share_i k/2 |x_i - a_i|^2.
///
/// @param nodes, shares  shares sum to 1
/// @param places_m       a_i, 3 x nodes, world frame
/// @param stiffness_N_m  k >= 0, of all springs together, parameter
ForceElementPointer point_pull(const Body& body, const std::vector<int>& nodes, const Eigen::VectorXd& shares,
                               const Eigen::Matrix3Xd& places_m, double stiffness_N_m);

}  // namespace myo::model
