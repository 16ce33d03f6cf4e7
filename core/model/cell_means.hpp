#pragma once

#include <Eigen/Core>

#include "model/model.hpp"

namespace myo::model {

/// What a body feels, as means over each cell.
///
/// The stress is Cauchy's: sum of w P F' over sum of w J, the mean over the deformed cell, of the law and the fibres;
/// neither damping nor the memory of creep and softening is in it. A law or fibre that has no stress there leaves NaN.
struct CellMeans {
    Eigen::VectorXd stretch;       // largest principal stretch, mean over the rest volume
    Eigen::VectorXd von_mises_Pa;  // sqrt(3/2 dev(sigma) : dev(sigma))
    Eigen::VectorXd pressure_Pa;   // -tr(sigma) / 3
};

/// @param x         3 x n [m]
/// @param activation  per fibre group
CellMeans cell_means(const Model& model, const Eigen::Matrix3Xd& x, const std::vector<double>& activation);

/// Values per cell as values per node: the mean of a node's cells, weighted with their volumes [m3].
Eigen::VectorXd at_nodes(const mesh::VolumeMesh& mesh, const Eigen::VectorXd& cell_values,
                         const Eigen::VectorXd& volumes_m3);

}  // namespace myo::model
