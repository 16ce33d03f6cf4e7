#pragma once

#include <Eigen/Core>

namespace myo::model {

/// Replaces a symmetric matrix by the nearest positive semidefinite one: negative eigenvalues become 0.
void project_positive(Eigen::Ref<Eigen::MatrixXd> K);

}  // namespace myo::model
