#pragma once

#include <memory>

#include "base/progress.hpp"
#include "fibre/brush.hpp"
#include "mesh/box_tree.hpp"
#include "mesh/surface_mesh.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::ui::commands {

/// What painting needs to know of a meshed body, in its rest frame: made once for each mesh, which takes some frames'
/// time.
struct PaintGround {
    Eigen::Matrix2Xi neighbours;  // of cells, 2 x k
    fibre::CellPlaces places;
    Eigen::VectorXd volumes_m3;                   // of cells
    Eigen::Vector3d longest_axis;                 // of the body, unit
    Eigen::Vector3d middle_m;                     // of its bounding box
    mesh::SurfaceMesh surface;                    // the body's own: smooth where voxels have steps
    mesh::BoxTree triangles{std::vector<Box>{}};  // of it
};

/// Null when cancelled.
std::shared_ptr<const PaintGround> paint_ground(const mesh::SurfaceMesh& body_surface, const mesh::VolumeMesh& mesh,
                                                const Progress& progress = {});

/// Outward normal, unit, of the body's own surface where that is nearest to a point.
Eigen::Vector3d outward_at(const PaintGround& ground, const Eigen::Vector3d& position_m);

}  // namespace myo::ui::commands
