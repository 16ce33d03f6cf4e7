#include "model/positive_part.hpp"

#include "base/decompositions.hpp"

namespace myo::model {

// Dynamic size: the projection is rare compared with element loops.
void project_positive(Eigen::Ref<Eigen::MatrixXd> K) {
    const SymmetricEigen eigen = symmetric_eigen(K);
    if (eigen.values(0) >= 0.0) return;
    K = eigen.vectors * eigen.values.cwiseMax(0.0).asDiagonal() * eigen.vectors.transpose();
}

}  // namespace myo::model
