#pragma once

#include "mesh/closest_point.hpp"
#include "model/force_element.hpp"

namespace myo::model {

/// A linear spring from a point of the surface to a fixed anchor, unstretched in the rest shape: energy k/2 (|p - a| -
/// l0)^2; it pulls and pushes.
///
/// @param nodes, shares  the point as a sum over nodes of one cell, shares add up to 1
/// Parameter: stiffness_N_m, not negative. Asserts that anchor and point are apart.
ForceElementPointer tied_spring(const Body& body, int cell, const std::vector<int>& nodes,
                                const Eigen::VectorXd& shares, const Eigen::Vector3d& anchor_m, double stiffness_N_m);

}  // namespace myo::model
