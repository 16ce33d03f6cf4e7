#pragma once

#include <Eigen/Core>

#include <filesystem>

#include "base/result.hpp"
#include "fibre/cell_paint.hpp"
#include "fibre/fibre_group.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::fibre {

/// A muscle as a person painted it, element by element, kept by place so that it can be put on any mesh of the body.
///
/// Rest frame, m. Beside the painted elements it holds their unpainted neighbours with weight 0: they say where the
/// paint ends.
struct PaintedMask {
    double cell_size_m = 0.0;      // mean edge of the painted elements
    Eigen::Matrix3Xd centroids_m;  // 3 x n
    Eigen::VectorXd weights;       // n, the share of each element that is muscle, 0 ... 1
    Eigen::Matrix3Xd directions;   // 3 x n, unit; signs do not matter, nor do those of weight 0

    Eigen::Index count() const { return weights.size(); }
};

/// The mask of a painted mesh.
PaintedMask mask_of_cells(const mesh::VolumeMesh& mesh, const CellPaint& paint);

/// Text, one row per element: `x_m,y_m,z_m,weight,fibre_x,fibre_y,fibre_z`, below a line with the cell size.
Result<void> write_painted_mask(const std::filesystem::path& path, const PaintedMask& mask);

/// Errors, with line: no cell size, another header, fields that are no numbers, weights outside 0 ... 1, directions
/// that are not unit vectors within 1 %, nothing painted.
Result<PaintedMask> read_painted_mask(const std::filesystem::path& path);

/// Fibres in the painted part of a mesh, which need not be the one that was painted.
///
/// A cell that was itself painted has just its weight. Any other is asked at places a quarter of the mask's cell size
/// apart: each takes the weight and the direction of the nearest element within the cell size, and directions are
/// averaged as lines.
FibreGroup fibres_of_mask(const mesh::VolumeMesh& mesh, const PaintedMask& mask, double stiffness_Pa, std::string name);

/// The mask as paint on a mesh, which need not be the one that was painted: the share of each cell that
/// fibres_of_mask() makes muscle, and its mean line.
CellPaint paint_of_mask(const mesh::VolumeMesh& mesh, const PaintedMask& mask);

}  // namespace myo::fibre
