#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <limits>
#include <vector>

#include "model/body.hpp"

namespace myo::model {

/// Inertia without weight that acts along fixed directions in space, during [from_s, until_s). Velocities are
/// continuous when a mass is attached or removed: an attached mass takes the velocity of the body.
struct DirectionalMass {
    // 3n x 3n, row 3 i + r; symmetric, positive semidefinite; couples nodes of one cell only
    Eigen::SparseMatrix<double> inertia_kg;
    double from_s = -std::numeric_limits<double>::infinity();  // [s] start, included
    double until_s = std::numeric_limits<double>::infinity();  // [s] end, excluded

    /// True at time t [s].
    bool active(double t) const { return t >= from_s && t < until_s; }
};

/// Added mass of a fluid layer that moves with the surface along its normal and slips tangentially: traction
/// -surface_density (a . n) n per rest area, with the rest normal n.
///
/// @param faces                  faces of the body's boundary
/// @param surface_density_kg_m2  mass of the layer per rest area, >= 0
DirectionalMass added_mass(const Body& body, const std::vector<int>& faces, double surface_density_kg_m2);

/// Inertia of a body suspended from a thread; acts along the thread only, whose direction stays that at rest.
/// @param share      per node, sums to 1; the mass is lumped at the nodes
/// @param direction  of the thread, any length except 0
/// @param mass_kg    >= 0
DirectionalMass line_mass(const Eigen::VectorXd& share, const Eigen::Vector3d& direction, double mass_kg);

}  // namespace myo::model
