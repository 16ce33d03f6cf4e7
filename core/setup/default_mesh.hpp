#pragma once

#include <array>
#include <vector>

#include "fem/element_block.hpp"
#include "mesh/box_mesh.hpp"
#include "mesh/surface_mesh.hpp"

namespace myo::setup {

/// How fine a body is meshed where no edge length is asked for, and where a mesh is called unsuitable.
///
/// Measured on cantilevers (test DefaultMesh): with these numbers bars, strips, plates and columns bend within 2 % and
/// twist within 6 % of a converged mesh, with an element whose single layer bends within 2 %.
struct MeshPolicy {
    double hexahedra_per_size = 6.0;  // edges per cube root of the body's volume: about a thousand unknowns
    double tetrahedra_per_size = 3.0;
    int least_layers = 2;      // of hexahedra across the body wherever it has parallel faces
    int few_rod_layers = 3;    // a rod of so many in one direction across and fewer in the other twists 9 to 14 % too
    int rod_layers = 4;        // little: it gets these, 4 %. Compact bars of 3 x 3, 7 %, stay as they are
    double rod_aspect = 4.0;   // along a rod cells may be so many times longer: bending is resolved, unknowns are saved
    double most_aspect = 5.0;  // of cells made flat by their layers; longer edges are shortened ...
    double least_edge_share = 0.5;     // ... to this part at most: a sheet would take millions of cells
    double least_part = 0.05;          // of the volume: smaller parts get their layers but do not shorten other edges
    double edge_over_thickness = 1.5;  // tetrahedra: longer edges leave cells without shape
    double rod_edge_over_thickness = 0.7;  // of rods: with one layer they twist 18 % too little, with two 5 %
    double least_rod_surface = 3.0;        // surface times thickness over volume: plates have 2, rods 4
    double thickness_quantile = 0.1;       // of the surface, that is at most so thick: tips and rims do not count
    int thickness_rays = 400;
    double most_unknowns = 30'000;  // to which edges are shortened for the thickness
};
inline constexpr MeshPolicy mesh_policy;

/// A slice of a rectilinear body between neighbouring planes of its faces: low to high along the axis.
struct BodySlice {
    int axis = 0;
    double low = 0.0, high = 0.0;  // [m]
    double thin_share = 0.0;       // volume of its blocks with the outside on both sides, over the body's
    bool thin_rod = false;         // some of these are thin along another axis as well
    double rod_thickness_m = 0.0;  // where all its blocks are rods along the axis, of the thinnest; 0 elsewhere

    double thickness_m() const { return high - low; }
};

/// True when every triangle lies in a plane x, y or z = constant: such a body is filled by hexahedra exactly.
bool is_rectilinear(const mesh::SurfaceMesh& surface);

/// Coordinates of the surface's axis-aligned faces, joined when nearer than a hundredth of the edge length.
mesh::GridPlanes face_planes(const mesh::SurfaceMesh& surface, double edge);

/// All slices; empty for a body that is not rectilinear.
/// @param edge  of the cells without regard to slices [m]: it decides where a body counts as a rod
std::vector<BodySlice> body_slices(const mesh::SurfaceMesh& surface, double edge);

/// Thickness that all but a small part of the surface exceeds [m]: along rays inward from its triangles.
double local_thickness(const mesh::SurfaceMesh& surface);

/// The longest edge of tetrahedra that bend and twist within a few percent where a body is `thickness_m` thick [m].
double longest_edge(const mesh::SurfaceMesh& surface, double thickness_m);

/// hex8 for rectilinear bodies, tet10 for all others.
fem::ElementKind automatic_element(const mesh::SurfaceMesh& surface);

/// Edge length that resolves the body with about a thousand unknowns, more where it is thin [m].
double automatic_resolution(const mesh::SurfaceMesh& surface, mesh::CellType type);

/// Edge lengths of the automatic hexahedra: the automatic resolution, shorter across thin parts and longer along rods;
/// all times `refinement`.
mesh::EdgeAt automatic_edges(const mesh::SurfaceMesh& surface, double refinement);

}  // namespace myo::setup
