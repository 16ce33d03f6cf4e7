#pragma once

#include <vector>

#include "mesh/clipping.hpp"
#include "mesh/surface_mesh.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::mesh {

/// Tolerance for a coordinate to count as lying on a side of a box.
///
/// @return  1e-9 of the largest extent of the mesh [m]; 0 for an empty mesh
double region_tolerance(const VolumeMesh& mesh);

/// Nodes inside a box.
///
/// @param tolerance  the box is grown by this length on all sides [m]
/// @return           node numbers, ascending
std::vector<int> nodes_in_box(const VolumeMesh& mesh, const Box& box, double tolerance);
/// nodes_in_box() with region_tolerance().
std::vector<int> nodes_in_box(const VolumeMesh& mesh, const Box& box);

/// Shape functions integrated over part of the boundary.
struct SurfaceIntegral {
    Eigen::VectorXd weight;  // per node of the mesh [m2], sum = area; corners of tet10 faces may be <= 0
    double area = 0.0;       // [m2]
};

/// Integrates the shape functions over the boundary inside an axis-aligned box.
///
/// The box cuts faces exactly and may be thinner than a cell; a face in a side of the box counts once. Exact for flat
/// parallelograms and straight-sided triangles. A warped quadrilateral is approximated by four flat triangles around
/// its centre, a curved tet10 face by four triangles through its mid-side nodes.
SurfaceIntegral surface_weights(const VolumeMesh& mesh, const BoundaryFaces& faces, const Box& box);

/// Part of a cell inside a box, exact for flat faces. A warped hexahedron face counts as four triangles, which
/// preserves the trilinear volume; a curved tet10 counts as eight straight tetrahedra.
/// @param tolerance  [m], see clip_to_box()
ClippedVolume cell_in_box(const VolumeMesh& mesh, Eigen::Index cell, const Box& box, double tolerance);

/// Fraction of the volume of each cell inside a box, computed by cell_in_box().
///
/// @return  one value per cell, 0 to 1
Eigen::VectorXd volume_fractions(const VolumeMesh& mesh, const Box& box);

}  // namespace myo::mesh
