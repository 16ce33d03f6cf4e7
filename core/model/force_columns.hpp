#pragma once

#include <Eigen/Core>

#include <vector>

#include "model/internal_forces.hpp"

namespace myo::model {

/// Several nodal fields of 3 x n in one matrix: rows 3 p ... 3 p + 2 are field p. The vectors of a node are contiguous.
using NodalColumns = Eigen::MatrixXd;
/// Field p as a 3 x n view.
inline auto nodal_column(NodalColumns& columns, Eigen::Index p) { return columns.middleRows<3>(3 * p); }
inline auto nodal_column(const NodalColumns& columns, Eigen::Index p) { return columns.middleRows<3>(3 * p); }

/// Elastic and viscous forces per unit of each modulus, as vectors at the nodes of the cells (see NodeIncidence).
///
/// The energy is linear in the moduli of each cell, so gradients along any change of moduli are weighted sums of these.
struct UnitForces {
    std::vector<Pack> mu, kappa, viscous;  // per pack of cells: 3 x nodes packs
};
/// Unit forces at a configuration.
/// @param x          node positions, 3 x n [m]
/// @param softening  factors of the elastic moduli at the points, in addition to the model's; empty: 1
/// @param rate       strain rates at x, strain_count entries; empty: no viscous forces
UnitForces unit_forces(const Model& model, const Eigen::Matrix3Xd& x, const Eigen::VectorXd& softening,
                       const Eigen::VectorXd& rate);

/// Directions of differentiation, P columns.
struct GradientChanges {
    std::vector<Stiffness> stiffness;  // change of the moduli per cell; empty parts are zero, factors unused
    Eigen::MatrixXd rates;             // strain_count x P: change of the strain rates; or empty
    Eigen::MatrixXd softening;         // point_count x P: change of the factors of the elastic moduli; or empty
};

/// Directional derivatives of dW/dx at x, fibres excluded, 3 P x n [N]. Bitwise independent of the number of threads.
NodalColumns gradient_columns(const Model& model, const Eigen::Matrix3Xd& x, const UnitForces& forces,
                              const GradientChanges& changes);

/// strain_tangent() along P nodal motions, with one pass over the cells.
/// @param dx  3 P x n
/// @return    strain_count x P
Eigen::MatrixXd strain_tangents(const Model& model, const Eigen::Matrix3Xd& x, const NodalColumns& dx);

}  // namespace myo::model
