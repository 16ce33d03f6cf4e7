#pragma once

#include <Eigen/Core>

#include <vector>

#include "model/internal_forces.hpp"

namespace myo::model {

/// Adds the energy of all fibre groups at the positions x (3 x n [m]) with its derivatives. activation: per group.
void add_fibres(const Model& model, const Eigen::Matrix3Xd& x, const std::vector<double>& activation, HessianKind kind,
                InternalEnergy& out);

}  // namespace myo::model
