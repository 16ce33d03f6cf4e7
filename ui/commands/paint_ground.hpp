#pragma once

#include "fibre/brush.hpp"
#include "mesh/box_tree.hpp"
#include "mesh/surface_mesh.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo {

/// What painting needs to know of a meshed body, in its rest frame: made once for each mesh, which takes some frames' time.
struct PaintGround {
    PaintGround(const SurfaceMesh& body_surface, const VolumeMesh& mesh);

    Eigen::Matrix2Xi neighbours;        // of cells, 2 x k
    CellPlaces places;
    Eigen::VectorXd volumes_m3;         // of cells
    Eigen::Vector3d longest_axis;       // of the body, unit
    Eigen::Vector3d middle_m;           // of its bounding box
    SurfaceMesh surface;                // the body's own: smooth where voxels have steps
    BoxTree triangles;                  // of it
};

/// Outward normal, unit, of the body's own surface where that is nearest to a point.
Eigen::Vector3d outward_at(const PaintGround& ground, const Eigen::Vector3d& position_m);

}  // namespace myo
