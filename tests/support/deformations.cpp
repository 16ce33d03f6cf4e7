#include "support/deformations.hpp"

namespace myo::test {

/// Four normal numbers, normalised, are a uniformly distributed unit quaternion.
Eigen::Matrix3d random_rotation(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
        .normalized()
        .toRotationMatrix();
}

Eigen::Matrix3d random_deformation(std::mt19937& random, double lowest, double highest) {
    std::uniform_real_distribution<double> stretch(lowest, highest);
    const Eigen::Vector3d s(stretch(random), stretch(random), stretch(random));
    const Eigen::Matrix3d U = random_rotation(random), V = random_rotation(random);
    return U * s.asDiagonal() * V.transpose();
}

std::vector<Eigen::Matrix3d> sample_deformations() {
    // A fixed seed: each run tests the same deformations.
    std::mt19937 random(7);
    std::vector<Eigen::Matrix3d> F;
    for (int k = 0; k < 3; ++k) F.push_back(random_deformation(random, 0.97, 1.03));
    for (int k = 0; k < 3; ++k) F.push_back(random_deformation(random, 0.7, 1.4));
    for (int k = 0; k < 3; ++k) F.push_back(random_deformation(random, 0.4, 3.0));
    return F;
}

}  // namespace myo::test
