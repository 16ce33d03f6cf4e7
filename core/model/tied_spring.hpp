#pragma once

#include "mesh/closest_point.hpp"
#include "model/force_element.hpp"

namespace myo::model {

/// Linear spring between a surface point p and a fixed anchor a, stress-free in the rest configuration: energy k/2 (|p
/// - a| - l0)^2. Acts in tension and compression.
///
/// @param cell           cell that contains the nodes
/// @param nodes, shares  p = sum of shares times node positions; shares sum to 1
/// @param anchor_m       a, world frame; asserts a != p in the rest configuration
/// @param stiffness_N_m  k >= 0, parameter
ForceElementPointer tied_spring(const Body& body, int cell, const std::vector<int>& nodes,
                                const Eigen::VectorXd& shares, const Eigen::Vector3d& anchor_m, double stiffness_N_m);

}  // namespace myo::model
