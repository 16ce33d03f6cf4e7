#pragma once

#include <Eigen/Core>

#include "model/model.hpp"

namespace myo::model {

/// Isochoric energy density at each point of the body [J/m3], the part governed by the shear modulus; see
/// Body::point_entry.
/// @param x  node positions, 3 x n [m]
/// @return   point_count entries; non-finite where the law is undefined
Eigen::VectorXd isochoric_energy_densities(const Model& model, const Eigen::Matrix3Xd& x);

/// Transpose of the derivative of isochoric_energy_densities(): nodal gradient of the sum of weight times density.
/// @param weights  point_count entries; the unit of the result is that of a weight times J/m4
/// @return         3 x n
Eigen::Matrix3Xd isochoric_energy_gradient(const Model& model, const Eigen::Matrix3Xd& x,
                                           const Eigen::VectorXd& weights);

/// Virtual work p . dW/dx of the elastic forces per unit of the factor of the moduli at each point.
///
/// Transpose of the change of forces by GradientChanges::softening.
/// @param p  nodal motion, 3 x n
/// @return   point_count entries
Eigen::VectorXd point_factor_work(const Model& model, const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& p);

}  // namespace myo::model
