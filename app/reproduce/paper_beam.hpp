#pragma once

#include <Eigen/Core>

#include <array>
#include <string>

#include "mesh/closest_point.hpp"
#include "model/model.hpp"

namespace myo::reproduce {

/// The clamped beam of the paper: 100 x 30 x 30 mm, tip at x = 0, clamp at x = -100 mm, z up, gravity along -z, and a
/// dead force on the upper edge of the tip. The defaults are our model; the alternatives are those of the published
/// program. Source: Dubied et al. 2022, sec. IV, and its public scripts.
struct PaperBeam {
    fem::ElementKind element = fem::ElementKind::hex8;
    Eigen::Vector3i cells{23, 7, 7};  // equal cells that fill the beam
    double cube_edge_m = 0.0;         // > 0: whole cubes of this edge, as published; the body shrinks
    model::MassModel mass_model = model::MassModel::consistent;
    std::string material = "neo_hookean";
    double youngs_modulus_Pa = 263824.0;  // of the paper, fitted with a commercial solver
    double damping_s = 0.0;
    double velocity_force_1_s = 0.0;
    double tip_force_N = 0.0;  // downwards
};
/// Model of this beam, with the options of the struct and a Poisson's ratio of 0.499. Asserts that cubes fit.
model::Model make_paper_beam(const PaperBeam& beam);

/// The published beam: 23 or 32 whole cubes along the length (fewer for coarse runs), full integration, projective
/// energy, equal vertex masses.
PaperBeam published_hex_beam(int cells_along);

/// Vertex mass of the published program for its 23 x 7 x 7 cubes [kg]: density times volume of a cube.
double published_vertex_mass_kg();

/// Column of the point Left.
inline constexpr int left_marker = 1;
/// Points on the surface of the tip closest to the tracked markers [m]: the paper's Top, Left and Right.
const std::array<Eigen::Vector3d, 3>& beam_surface_points();

/// The tip's surface points on a mesh; at the same relative position if truncated voxels made the body smaller.
std::array<mesh::BoundaryPoint, 3> bind_beam_points(const model::Model& model);

/// Their displacements [m], columns Top, Left, Right, interpolated in the faces; linear in the nodal displacements.
///
/// @param displacements  3 x n [m]
Eigen::Matrix3d beam_point_displacements(const std::array<mesh::BoundaryPoint, 3>& points,
                                         const Eigen::Matrix3Xd& displacements);

}  // namespace myo::reproduce
