#pragma once

#include <optional>

#include "model/force_element.hpp"

namespace myo::model {

/// Regularised Coulomb friction at one point of the surface, from t = 0 on: force -F v_t / sqrt(|v_t|^2 + v0^2).
///
/// v_t is the point's velocity across `normal`, a direction fixed in space, or the whole velocity without one. The
/// force is the gradient of the dissipation potential F sqrt(|v_t|^2 + v0^2).
/// @param nodes, shares  the point as a sum over nodes of one cell, shares add up to 1
/// @param v0_m_s         speed below which the force is nearly linear in the velocity; positive
/// Parameter: friction_force_N, not negative.
ForceElementPointer point_friction(const Body& body, int cell, const std::vector<int>& nodes,
                                   const Eigen::VectorXd& shares, const std::optional<Eigen::Vector3d>& normal,
                                   double friction_force_N, double v0_m_s);

}  // namespace myo::model
