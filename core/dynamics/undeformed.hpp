#pragma once

#include <Eigen/Core>

#include "model/body.hpp"

namespace myo::dynamics {

/// Stress-free configuration closest to x, 3 x n [m]: the rest shape if nodes are clamped, otherwise the rest shape
/// moved and rotated as a rigid body to match x.
///
/// Every material law is defined there, which makes it a safe start of an iteration.
Eigen::Matrix3Xd undeformed_near(const model::Body& body, const Eigen::Matrix3Xd& x);

}  // namespace myo::dynamics
