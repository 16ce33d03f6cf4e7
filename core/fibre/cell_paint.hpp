#pragma once

#include <Eigen/Core>

#include "fibre/fibre_group.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::fibre {

/// Muscle painted on a mesh, per cell.
struct CellPaint {
    Eigen::VectorXd weights;      // per cell: volume fraction of muscle, 0 ... 1
    Eigen::Matrix3Xd directions;  // 3 x cells, unit where the weight is not 0; the sign is arbitrary

    /// Number of cells.
    Eigen::Index count() const { return weights.size(); }
};
/// Paint with zero weights.
CellPaint blank_paint(const mesh::VolumeMesh& mesh);

/// Volume fraction and mean direction of a fibre group in each cell. Asserts that the group has its gradients.
CellPaint paint_of_group(const mesh::VolumeMesh& mesh, const FibreGroup& group);

/// Size of a painted region.
struct PaintedAmount {
    int cells = 0;           // cells with weight > 0
    double volume_m3 = 0.0;  // volume of muscle
};
/// Painted cells and volume.
/// @param volumes_m3  per cell
PaintedAmount amount_of(const CellPaint& paint, const Eigen::VectorXd& volumes_m3);

/// Dilation by one layer: unpainted neighbours of painted cells get the mean weight and mean direction of these.
///
/// @param neighbours  pairs of cells, 2 x k, from neighbouring_cells()
CellPaint grown(const CellPaint& paint, const Eigen::Matrix2Xi& neighbours);

/// Erosion by one layer: painted neighbours of unpainted cells lose their paint. The surface of the body does not count
/// as an edge.
CellPaint shrunk(const CellPaint& paint, const Eigen::Matrix2Xi& neighbours);

/// Flood fill: paints all unpainted cells connected to `cell` with weight 1. Directions interpolate the existing ones
/// smoothly, or are `axis` if nothing is painted yet. No effect if the cell is already painted.
///
/// @param axis  unit vector
CellPaint filled(const CellPaint& paint, const mesh::VolumeMesh& mesh, const Eigen::Matrix2Xi& neighbours, int cell,
                 const Eigen::Vector3d& axis);

}  // namespace myo::fibre
