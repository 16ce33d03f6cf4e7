#pragma once

#include <Eigen/Core>

#include "model/model.hpp"

namespace myo::model {

/// Isochoric energy density at each point of the body [J/m3], the part governed by the shear modulus; see
/// Body::point_entry.
/// @param x  node positions, 3 x n [m]
/// @return   point_count entries; non-finite where the law is undefined
Eigen::VectorXd isochoric_energy_densities(const Model& model, const Eigen::Matrix3Xd& x);

}  // namespace myo::model
