#pragma once

#include <Eigen/Core>

#include "fibre/fibre_group.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::fibre {

/// Muscle painted on a mesh, cell by cell.
struct CellPaint {
    Eigen::VectorXd weights;      // per cell, the share of it that is muscle, 0 ... 1
    Eigen::Matrix3Xd directions;  // 3 x cells, unit where the weight is not 0; signs do not matter

    Eigen::Index count() const { return weights.size(); }
};
CellPaint blank_paint(const mesh::VolumeMesh& mesh);

/// The share of each cell that fibres stand for, and their mean line there.
CellPaint paint_of_group(const mesh::VolumeMesh& mesh, const FibreGroup& group);

struct PaintedAmount {
    int cells = 0;           // with any paint
    double volume_m3 = 0.0;  // of muscle
};
/// @param volumes_m3  per cell
PaintedAmount amount_of(const CellPaint& paint, const Eigen::VectorXd& volumes_m3);

/// One layer more: cells without paint beside painted ones get their mean weight and mean line.
///
/// @param neighbours  as neighbouring_cells() gives them, 2 x k
CellPaint grown(const CellPaint& paint, const Eigen::Matrix2Xi& neighbours);

/// One layer less: painted cells beside ones without paint lose theirs. The surface of the body is no edge.
CellPaint shrunk(const CellPaint& paint, const Eigen::Matrix2Xi& neighbours);

/// All that can be reached from a cell without paint, up to painted cells and the surface, is painted wholly: as smooth
/// as can be between the directions that are there, or along `axis` where nothing is painted yet. Nothing where the
/// cell itself has paint.
///
/// @param axis  unit
CellPaint filled(const CellPaint& paint, const mesh::VolumeMesh& mesh, const Eigen::Matrix2Xi& neighbours, int cell,
                 const Eigen::Vector3d& axis);

}  // namespace myo::fibre
