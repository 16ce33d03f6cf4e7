#pragma once

#include <Eigen/Dense>

#include <random>
#include <vector>

namespace myo::test {

/// A random rotation, uniformly distributed.
Eigen::Matrix3d random_rotation(std::mt19937& random);

/// F = U diag(stretches) V' with det F > 0 and principal stretches in [lowest, highest]. The generator advances.
Eigen::Matrix3d random_deformation(std::mt19937& random, double lowest, double highest);

/// Small, moderate and strong deformations, including changes of volume. The same ones in each run.
std::vector<Eigen::Matrix3d> sample_deformations();

}  // namespace myo::test
