#pragma once

#include <Eigen/Core>

#include "model/model.hpp"

namespace myo::model {

/// Cell averages of stretch and stress, for display.
///
/// Cauchy stress sum(w P F') / sum(w J) over the points, of material law and fibres; damping, creep and softening
/// memory are not included. NaN where a law or fibre has no stress.
struct CellMeans {
    Eigen::VectorXd stretch;       // per cell, largest principal stretch, averaged over the rest volume
    Eigen::VectorXd von_mises_Pa;  // per cell, sqrt(3/2 dev(sigma) : dev(sigma))
    Eigen::VectorXd pressure_Pa;   // per cell, -tr(sigma) / 3
};

/// Cell averages at a configuration.
/// @param x           node positions, 3 x n [m]
/// @param activation  per fibre group
CellMeans cell_means(const Model& model, const Eigen::Matrix3Xd& x, const std::vector<double>& activation);

/// Cell values averaged to the nodes, weighted by the cell volumes.
///
/// @param cell_values  one per cell, any unit
/// @param volumes_m3   one per cell
/// @return             one per node; 0 at nodes without cells
Eigen::VectorXd at_nodes(const mesh::VolumeMesh& mesh, const Eigen::VectorXd& cell_values,
                         const Eigen::VectorXd& volumes_m3);

}  // namespace myo::model
