#pragma once

#include <Eigen/Core>

#include <vector>

#include "model/internal_forces.hpp"

namespace myo::model {

/// Several nodal fields at once: rows 3 p ... 3 p + 2 are field p, 3 x n; so a node's vectors lie side by side.
using NodalColumns = Eigen::MatrixXd;
inline auto nodal_column(NodalColumns& columns, Eigen::Index p) { return columns.middleRows<3>(3 * p); }
inline auto nodal_column(const NodalColumns& columns, Eigen::Index p) { return columns.middleRows<3>(3 * p); }

/// Forces of elasticity and of viscosity per unit of each modulus, as vectors at the cells' nodes (see NodeIncidence):
/// the energy is linear in the moduli of every cell, so that its gradients along any changes of them are weighted sums
/// of these.
struct UnitForces {
    std::vector<Pack> mu, kappa, viscous;  // nodes per cell x 3 packs per pack of cells
};
/// softening: factors of the elastic moduli at the points besides the model's own; empty: 1. rate: strain rates at x;
/// empty: without viscous forces.
UnitForces unit_forces(const Model& model, const Eigen::Matrix3Xd& x, const Eigen::VectorXd& softening,
                       const Eigen::VectorXd& rate);

/// What gradients are taken along, one column each.
struct GradientChanges {
    std::vector<Stiffness> stiffness;  // moduli per cell; empty parts are zero, factors unused
    Eigen::MatrixXd rates;             // strain_count x P, of strain rates in the model's viscous forces; or empty
    Eigen::MatrixXd softening;  // point_count x P, of factors on the model's elastic moduli at the points; or empty
};

/// Changes of dW/dx at x (without fibres). Bits do not depend on the number of threads.
NodalColumns gradient_columns(const Model& model, const Eigen::Matrix3Xd& x, const UnitForces& forces,
                              const GradientChanges& changes);

/// strain_tangent() along each of P motions: strain_count x P.
Eigen::MatrixXd strain_tangents(const Model& model, const Eigen::Matrix3Xd& x, const NodalColumns& dx);

}  // namespace myo::model
