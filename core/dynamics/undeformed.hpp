#pragma once

#include <Eigen/Core>

#include "model/body.hpp"

namespace myo::dynamics {

/// The undeformed body nearest to x (3 x n): where it is clamped, or moved and turned as a whole where it is not. Every
/// law has an energy there, so that a search may start from it.
Eigen::Matrix3Xd undeformed_near(const model::Body& body, const Eigen::Matrix3Xd& x);

}  // namespace myo::dynamics
