#pragma once

#include <vector>

#include "mesh/clipping.hpp"
#include "mesh/surface_mesh.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::mesh {

/// Length below which a coordinate counts as lying on a box face: 1e-9 of the mesh's largest extent [m].
double region_tolerance(const VolumeMesh& mesh);

/// Nodes inside the box grown by `tolerance` [m] on every side, ascending.
std::vector<int> nodes_in_box(const VolumeMesh& mesh, const Box& box, double tolerance);
std::vector<int> nodes_in_box(const VolumeMesh& mesh, const Box& box);

/// Shape functions integrated over a part of the boundary.
struct SurfaceIntegral {
    Eigen::VectorXd weight;  // per node of the mesh [m2]; their sum is the area. Corners of tet10 faces may be <= 0
    double area = 0.0;       // [m2]
};

/// Integrates the shape functions over the boundary inside an axis-aligned box.
///
/// Faces are cut exactly by the box, which may be thinner than a cell; a face lying in a side of the box counts once.
/// Exact for flat parallelograms and straight-sided triangles; a warped quadrilateral is taken as four flat triangles
/// around its centre, a curved tet10 face as four around its mid-nodes.
SurfaceIntegral surface_weights(const VolumeMesh& mesh, const BoundaryFaces& faces, const Box& box);

/// The part of a cell inside a box, exact for flat faces; a warped hexahedron face counts as four triangles (which
/// keeps the trilinear volume), a curved tet10 as eight straight tetrahedra.
ClippedVolume cell_in_box(const VolumeMesh& mesh, Eigen::Index cell, const Box& box, double tolerance);

/// Fraction of each cell's volume inside the box, 0 to 1, as cell_in_box() has it.
Eigen::VectorXd volume_fractions(const VolumeMesh& mesh, const Box& box);

}  // namespace myo::mesh
