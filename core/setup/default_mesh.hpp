#pragma once

#include <array>
#include <vector>

#include "fem/element_block.hpp"
#include "mesh/box_mesh.hpp"
#include "mesh/surface_mesh.hpp"

namespace myo::setup {

/// Default mesh density, used if no edge length is requested.
///
/// Measured on cantilevers (test DefaultMesh): with these numbers bars, strips, plates and columns bend within 2 % and
/// twist within 6 % of a converged mesh, with an element whose single layer bends within 2 %.
struct MeshPolicy {
    double hexahedra_per_size = 6.0;   // edges per cube root of the volume; about a thousand unknowns
    double tetrahedra_per_size = 3.0;  // the same for tetrahedra
    int min_layers = 2;                // of hexahedra between parallel faces
    /// A rod with at most this many layers in one direction and fewer in the other twists 9 to 14 % too little. Bars of
    /// 3 x 3 layers twist 7 % too little and stay as they are.
    int few_rod_layers = 3;
    int rod_layers = 4;                // that such a rod gets instead; it then twists 4 % too little
    double rod_aspect = 4.0;           // cells along a rod may be longer by this factor: bending stays resolved
    double max_aspect = 5.0;           // of cells flattened by thin layers; longer edges are shortened ...
    double min_edge_share = 0.5;       // ... but at most to this factor: a sheet would take millions of cells
    double min_part = 0.05;            // of the volume; smaller thin parts get layers but do not shorten other edges
    double edge_over_thickness = 1.5;  // of tetrahedra; longer edges give degenerate cells
    double rod_edge_over_thickness = 0.7;  // of rods: one layer twists 18 % too little, two layers 5 %
    double min_rod_surface = 3.0;          // surface times thickness over volume: plates have 2, rods 4
    double thickness_quantile = 0.1;       // of the surface that may be thinner: tips and rims do not count
    int thickness_rays = 400;              // sampled rays per body
    double max_unknowns = 30'000;          // limit up to which edges are shortened for thin parts
};
inline constexpr MeshPolicy mesh_policy;

/// Slice of a rectilinear body between adjacent planes of its faces: low to high along the axis.
struct BodySlice {
    int axis = 0;
    double low = 0.0, high = 0.0;  // [m]
    double thin_share = 0.0;       // volume of its blocks that are free on both sides, over the volume of the body
    bool thin_rod = false;         // some of these blocks are thin along another axis as well
    double rod_thickness_m = 0.0;  // if all its blocks are rods along the axis: the smallest thickness; else 0

    double thickness_m() const { return high - low; }
};

/// True if every triangle lies in a plane x, y or z = constant. Hexahedra fill such a body exactly.
bool is_rectilinear(const mesh::SurfaceMesh& surface);

/// Coordinates of the axis-aligned faces per axis [m], ascending; merged if closer than 0.01 `edge`.
mesh::GridPlanes face_planes(const mesh::SurfaceMesh& surface, double edge);

/// All slices of a rectilinear body; empty for any other body, or if the grid of its planes is too large.
///
/// @param edge  nominal edge length [m]; decides which blocks count as rods
std::vector<BodySlice> body_slices(const mesh::SurfaceMesh& surface, double edge);

/// Thickness [m] that all but thickness_quantile of the surface exceeds, from rays inward; infinite if no ray
/// hits.
double local_thickness(const mesh::SurfaceMesh& surface);

/// Longest edge [m] of tetrahedra that bend and twist within a few percent if the body is `thickness_m` thick, see
/// local_thickness(). Rods get shorter edges than plates, see MeshPolicy.
double longest_edge(const mesh::SurfaceMesh& surface, double thickness_m);

/// Default element: hex8 for rectilinear bodies, tet10 for all others.
fem::ElementKind automatic_element(const mesh::SurfaceMesh& surface);

/// Default edge length [m]: about a thousand unknowns, more if the body has thin parts. Zero if no volume is enclosed.
double automatic_resolution(const mesh::SurfaceMesh& surface, mesh::CellType type);

/// Edge length of the default hexahedra as a function of axis and coordinate [m]: automatic_resolution(), shorter
/// across thin parts, longer along rods; all times `refinement`.
mesh::EdgeAt automatic_edges(const mesh::SurfaceMesh& surface, double refinement);

}  // namespace myo::setup
