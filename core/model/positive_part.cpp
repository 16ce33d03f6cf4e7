#include "model/positive_part.hpp"

#include <Eigen/Eigenvalues>

namespace myo {

// Of any size at run time: this path is rare, and fixed sizes would cost minutes of compilation.
void project_positive(Eigen::Ref<Eigen::MatrixXd> K) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(K);
    if (eigen.eigenvalues()(0) >= 0.0) return;
    K = eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).asDiagonal() * eigen.eigenvectors().transpose();
}

}  // namespace myo
