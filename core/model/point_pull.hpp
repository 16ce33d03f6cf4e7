#pragma once

#include <vector>

#include "model/force_element.hpp"

namespace myo::model {

/// Spring without length between a surface point p and a place a, as a hand that pulls: energy k/2 |p - a|^2.
///
/// @param cell           cell that contains the nodes
/// @param nodes, shares  p = sum of shares times node positions; shares sum to 1
/// @param place_m        a, world frame
/// @param stiffness_N_m  k >= 0, parameter
ForceElementPointer point_pull(const Body& body, int cell, const std::vector<int>& nodes, const Eigen::VectorXd& shares,
                               const Eigen::Vector3d& place_m, double stiffness_N_m);

}  // namespace myo::model
