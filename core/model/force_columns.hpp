#pragma once

#include <Eigen/Core>

#include <vector>

#include "model/internal_forces.hpp"

namespace myo {

/// Several nodal fields at once: rows 3 p ... 3 p + 2 are field p, 3 x n; so a node's vectors lie side by side.
using NodalColumns = Eigen::MatrixXd;
inline auto nodal_column(NodalColumns& columns, Eigen::Index p) { return columns.middleRows<3>(3 * p); }
inline auto nodal_column(const NodalColumns& columns, Eigen::Index p) { return columns.middleRows<3>(3 * p); }

/// Forces of elasticity and of viscosity per unit of each modulus, as vectors at the cells' nodes (see NodeIncidence): the energy is linear
/// in the moduli of every cell, so that its gradients along any changes of them are weighted sums of these.
struct UnitForces {
    std::vector<Pack> mu, kappa, viscous;   // nodes per cell x 3 packs per pack of cells
};
/// rate: strain rates at x; empty: without viscous forces.
UnitForces unit_forces(const Model& model, const Eigen::Matrix3Xd& x, const Eigen::VectorXd& rate);

/// dW/dx at x of every stiffness (without fibres), and in addition the viscous_gradient() of the model for the strain rates in the
/// columns of `rates` (strain_count x P, or empty). Bits do not depend on the number of threads.
NodalColumns gradient_columns(const Model& model, const Eigen::Matrix3Xd& x, const UnitForces& forces, const std::vector<Stiffness>& stiffness,
                              const Eigen::MatrixXd& rates);

/// strain_tangent() along each of P motions: strain_count x P.
Eigen::MatrixXd strain_tangents(const Body& body, const Eigen::Matrix3Xd& x, const NodalColumns& dx);

}  // namespace myo
