#pragma once

#include "model/force_element.hpp"

namespace myo::model {

/// Elastic stop at one point of the surface: once the point has moved by a gap along minus `normal`, a linear spring
/// pushes it back along `normal`; the stop neither pulls nor rubs.
///
/// The potential is twice continuously differentiable: the spring's stiffness rises from 0 to its value over `onset_m`,
/// centred on the gap, so that the force beyond is that of a stop without onset.
/// @param nodes, shares  the point as a sum over nodes of one cell, shares add up to 1
/// @param normal         any length but 0
/// @param onset_m        positive
/// Parameters: stiffness_N_m, not negative, and gap_m.
ForceElementPointer point_stop(const Body& body, int cell, const std::vector<int>& nodes, const Eigen::VectorXd& shares,
                               const Eigen::Vector3d& normal, double gap_m, double stiffness_N_m, double onset_m);

}  // namespace myo::model
