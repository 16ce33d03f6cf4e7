#pragma once

#include <memory>

#include "base/progress.hpp"
#include "fibre/brush.hpp"
#include "mesh/box_tree.hpp"
#include "mesh/surface_mesh.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::ui::commands {

/// Data of a meshed body that painting requires, in its rest frame. Computed once per mesh on a background thread, as
/// it takes the time of several frames. Read-only afterwards.
struct PaintGround {
    Eigen::Matrix2Xi neighbours;                  // pairs of cells that share a face, 2 x k
    fibre::CellPlaces places;                     // centres and edge lengths of cells
    Eigen::VectorXd volumes_m3;                   // per cell
    Eigen::Vector3d longest_axis;                 // of the body, unit vector
    Eigen::Vector3d middle_m;                     // middle of the bounding box
    mesh::SurfaceMesh surface;                    // the body's own surface: smooth where voxel meshes have steps
    mesh::BoxTree triangles{std::vector<Box>{}};  // boxes of its triangles
};

/// Computes the data. Returns null if cancelled.
std::shared_ptr<const PaintGround> paint_ground(const mesh::SurfaceMesh& body_surface, const mesh::VolumeMesh& mesh,
                                                const Progress& progress = {});

/// Outward unit normal of the body's surface at its point nearest to `position_m`. Returns +z if there is no surface.
Eigen::Vector3d outward_at(const PaintGround& ground, const Eigen::Vector3d& position_m);

}  // namespace myo::ui::commands
