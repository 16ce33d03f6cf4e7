#pragma once

#include <Eigen/Core>

#include <filesystem>

#include "base/result.hpp"
#include "fibre/cell_paint.hpp"
#include "fibre/fibre_group.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::fibre {

/// Painted muscle, stored by position so that it can be transferred to any mesh of the body. Rest frame, m.
///
/// Contains the painted elements and their unpainted neighbours with weight 0, which mark where the paint ends.
struct PaintedMask {
    double cell_size_m = 0.0;      // mean edge length of the painted elements
    Eigen::Matrix3Xd centroids_m;  // 3 x n
    Eigen::VectorXd weights;       // n, volume fraction of muscle, 0 ... 1
    Eigen::Matrix3Xd directions;   // 3 x n, unit, sign arbitrary; unused at weight 0

    /// Number of elements.
    Eigen::Index count() const { return weights.size(); }
};

/// Mask of a painted mesh.
PaintedMask mask_of_cells(const mesh::VolumeMesh& mesh, const CellPaint& paint);

/// Writes a text file with one row per element, `x_m,y_m,z_m,weight,fibre_x,fibre_y,fibre_z`, after a line with the
/// cell size.
Result<void> write_painted_mask(const std::filesystem::path& path, const PaintedMask& mask);

/// Reads a file of write_painted_mask().
/// Errors, with line: no cell size, different header, fields that are not numbers, weights outside 0 ... 1, directions
/// that are not unit vectors within 1 %, no painted element.
Result<PaintedMask> read_painted_mask(const std::filesystem::path& path);

/// Fibres in the painted part of a mesh, which may differ from the painted mesh.
///
/// A cell that coincides with a mask element takes its weight. Other cells are sampled at a quarter of the mask's cell
/// size: each sample takes weight and direction of the nearest element within the cell size, and directions are
/// averaged with arbitrary sign.
FibreGroup fibres_of_mask(const mesh::VolumeMesh& mesh, const PaintedMask& mask, double stiffness_Pa, std::string name);

/// Paint on a mesh that may differ from the painted one: the volume fraction of muscle that fibres_of_mask() gives each
/// cell, and its mean direction.
CellPaint paint_of_mask(const mesh::VolumeMesh& mesh, const PaintedMask& mask);

}  // namespace myo::fibre
