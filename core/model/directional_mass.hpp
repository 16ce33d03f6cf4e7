#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <limits>
#include <vector>

#include "model/body.hpp"

namespace myo::model {

/// Inertia without weight that acts along directions only, fixed in space, within [from_s, until_s). The body's
/// velocities go on where a mass leaves it or joins it: one that joins brings the velocity along that it finds.
struct DirectionalMass {
    Eigen::SparseMatrix<double>
        inertia_kg;  // 3n x 3n, row 3 i + r; symmetric, positive semidefinite; couples nodes of one cell only
    double from_s = -std::numeric_limits<double>::infinity();
    double until_s = std::numeric_limits<double>::infinity();

    bool active(double t) const { return t >= from_s && t < until_s; }
};

/// Added mass of a fluid on part of the surface: traction -surface_density (a . n) n per rest area, n the normal at
/// rest.
///
/// faces: of the body's boundary. A layer of fluid of that mass per area goes with the surface along the normal and
/// slips along it.
DirectionalMass added_mass(const Body& body, const std::vector<int>& faces, double surface_density_kg_m2);

/// Inertia of a body that hangs on a thread: along the thread only. share: per node, sums to 1; direction: of any
/// length but 0.
DirectionalMass line_mass(const Eigen::VectorXd& share, const Eigen::Vector3d& direction, double mass_kg);

}  // namespace myo::model
