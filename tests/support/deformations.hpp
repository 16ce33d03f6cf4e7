#pragma once

#include <Eigen/Dense>

#include <random>
#include <vector>

namespace myo::test {

/// A rotation drawn evenly from all of them.
Eigen::Matrix3d random_rotation(std::mt19937& random);

/// F = U diag(stretches) V' with det F > 0 and principal stretches in [lowest, highest].
Eigen::Matrix3d random_deformation(std::mt19937& random, double lowest, double highest);

/// Small, moderate and strong deformations, volume changes included.
std::vector<Eigen::Matrix3d> sample_deformations();

}  // namespace myo::test
