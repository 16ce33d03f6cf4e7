#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "effect/effect.hpp"
#include "setup/body_mesh.hpp"
#include "setup/chambers.hpp"

namespace myo::setup {

/// Thresholds for warnings about a mesh. Percentages were measured against fine meshes (hex8, nu = 0.49).
struct SuitabilityPolicy {
    int min_layers = 2;                                 // of hexahedra; a single layer bends up to 70 % too far
    double min_part = 0.05;                             // of the volume that must be thin for a warning
    int min_rod_layers = 3;                             // across a rod in both directions
    double rod_twist_error_percent = 15.0;              // of 2 x 2 cells; 3 x 2: 9
    double rod_edge_over_thickness = 1.0;               // of tetrahedra; longer edges leave a single layer across a rod
    double tetrahedral_rod_twist_error_percent = 18.0;  // of one layer
    double layer_twist_error_percent = 5.0;             // of one layer, at least four cells wide
    double max_aspect = 10.0;                           // of a cell before it counts as flat
    double min_flat_share = 0.05;                       // of the cells that must be flat for a warning
    double min_cells_per_length = 1.0;                  // that an effect declares
    double max_chamber_area = 1.1;                      // of walls on the mesh over the declared one
    double chamber_error_percent = 20.0;  // of voxels: sphere and tube with 2 to 6 cells per wall, 5 to 20
};
inline constexpr SuitabilityPolicy suitability_policy;

/// Input of the mesh checks; refers to values of the caller.
struct MeshFacts {
    const mesh::SurfaceMesh& surface;
    const BodyMesh& mesh;
    const std::vector<effect::EffectDeclaration>& effects;
    const std::vector<Chamber>* chambers = nullptr;  // null: none
};

/// A check returns one sentence with measured value, threshold and remedy; empty if the mesh is suitable.
using MeshCheck = std::optional<std::string> (*)(const MeshFacts&);

/// Bending: fewer layers than min_layers, or edges too long for the thickness of the body.
std::optional<std::string> too_few_layers(const MeshFacts& body);
/// Torsion: too few cells across a rod.
std::optional<std::string> too_few_cells_to_twist(const MeshFacts& body);
/// Aspect ratio: too many flat cells.
std::optional<std::string> cells_too_flat(const MeshFacts& body);
/// Resolution of an effect: a length that it declares, such as the radius of a patch, is shorter than a cell.
std::optional<std::string> effect_too_small(const MeshFacts& body);
/// Chambers: voxels make stairs of walls that are not along the axes.
std::optional<std::string> chamber_of_stairs(const MeshFacts& body);

/// Number of cells across the thinnest wall of a body.
struct WallLayers {
    double count = 0.0;        // an integer for hexahedra in a body of axis-aligned faces; otherwise an estimate
    double thickness_m = 0.0;  // of the wall
};
/// Wall with the fewest layers; if layers cannot be counted, thickness of the body over the mean edge length.
WallLayers wall_layers(const MeshFacts& body);

/// All checks, in the order of their messages. Missing volume is reported by mesh_quality().
inline constexpr std::array<MeshCheck, 5> mesh_checks{too_few_layers, too_few_cells_to_twist, cells_too_flat,
                                                      effect_too_small, chamber_of_stairs};

/// Messages of all checks that fail; empty for a mesh without cells.
std::vector<std::string> unsuitable(const MeshFacts& body);

}  // namespace myo::setup
