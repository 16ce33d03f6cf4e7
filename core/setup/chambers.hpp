#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"
#include "experiment/experiment.hpp"
#include "model/force_element.hpp"
#include "setup/body_mesh.hpp"

namespace myo::setup {

/// A chamber on the mesh of its body.
struct Chamber {
    std::string name;
    std::vector<int> walls;     // faces of Body::boundary
    double volume_m3 = 0.0;     // of the declared cavity at rest
    double wall_area_m2 = 0.0;  // of the declared cavity at rest
    double mesh_area_m2 = 0.0;  // of the walls of the mesh; larger where voxels make stairs of them
    /// Declared volume over that of the mesh's cavity. The pressure on the walls and the reported volume are multiplied
    /// by it: without it a sphere of voxels moves up to 36 % too far or 6 % too little, depending on where the grid
    /// lies.
    double volume_factor = 1.0;
};

struct ChamberPolicy {
    /// Edges per width of a cavity, or of the wall between it and the outside, that keep it: a voxel is filled if half
    /// of it is solid, so that with two of them one is always clear.
    double edges_per_width = 2.0;
    double same_volume = 1e-9;  // relative; below it the volumes differ by rounding
};
inline constexpr ChamberPolicy chamber_policy;

/// Finds the walls of all declared chambers: the closed inner part of the boundary around the point of each.
///
/// @param surface  the declared surface of the body, closed
/// Errors: those of experiment::chamber_cavities(); a cavity that the mesh lost, at the key of its chamber, with a
/// resolution that keeps it.
Result<std::vector<Chamber>> find_chambers(const experiment::Experiment& experiment, const mesh::SurfaceMesh& surface,
                                           const BodyMesh& mesh, const model::Body& body);

/// The pressure of a chamber as force element, normal to the deformed walls.
model::ForceElementPointer chamber_pressure(const model::Body& body, const Chamber& chamber, fibre::Signal pressure_Pa);

/// Volume of a chamber [m3] at node positions x (3 x n [m]); at rest that of the declared cavity.
double chamber_volume(const model::Body& body, const Chamber& chamber, const Eigen::Matrix3Xd& x);

}  // namespace myo::setup
