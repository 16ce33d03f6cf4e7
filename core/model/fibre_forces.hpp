#pragma once

#include <Eigen/Core>

#include <vector>

#include "model/internal_forces.hpp"

namespace myo::model {

/// Adds the energy of all fibre groups with its derivatives.
///
/// @param x           node positions, 3 x n [m]
/// @param activation  per fibre group
/// @param kind        positive and positive_fibres clip the transverse curvature at 0
/// @param out         energy [J], gradient [N] and, unless kind is none, Hessian [N/m]; increased
void add_fibres(const Model& model, const Eigen::Matrix3Xd& x, const std::vector<double>& activation, HessianKind kind,
                InternalEnergy& out);

}  // namespace myo::model
