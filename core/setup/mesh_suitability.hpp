#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "effect/effect.hpp"
#include "setup/body_mesh.hpp"

namespace myo::setup {

/// Where a mesh is called unsuitable. Percentages were measured against fine meshes (hex8, nu = 0.49).
struct SuitabilityPolicy {
    int least_layers = 2;                   // of hexahedra; one bends up to 70 % too far
    double least_part = 0.05;               // of the body's volume that must be thin for a warning
    int least_rod_layers = 3;               // across a rod in both directions
    double rod_twist_error_percent = 15.0;  // of 2 x 2 cells; 3 x 2: 9
    double rod_edge_over_thickness = 1.0;   // of tetrahedra: longer edges leave a single layer across a rod
    double tetrahedral_rod_twist_error_percent = 18.0;
    double layer_twist_error_percent = 5.0;  // of one layer, at least four cells wide
    double most_aspect = 10.0;
    double least_flat_share = 0.05;       // of the cells that must be flatter for a warning
    double least_cells_per_radius = 1.0;  // of a soft patch
};
inline constexpr SuitabilityPolicy suitability_policy;

/// What the checks of a mesh look at.
struct MeshFacts {
    const mesh::SurfaceMesh& surface;
    const BodyMesh& mesh;
    const std::vector<effect::EffectDeclaration>& effects;
};

/// One sentence with figure, threshold and way out; nothing where the mesh is suitable.
using MeshCheck = std::optional<std::string> (*)(const MeshFacts&);

std::optional<std::string> too_few_layers(const MeshFacts& body);
std::optional<std::string> too_few_cells_to_twist(const MeshFacts& body);
std::optional<std::string> cells_too_flat(const MeshFacts& body);
std::optional<std::string> patch_too_small(const MeshFacts& body);

/// How many cells lie across a body's thinnest wall.
struct WallLayers {
    double count = 0.0;        // whole where layers can be counted: hexahedra in a body of axis-aligned faces
    double thickness_m = 0.0;  // of the wall
};
/// The wall with the fewest layers; where layers cannot be counted, the body's thickness over the mean edge.
WallLayers wall_layers(const MeshFacts& body);

/// All of them; what a mesh's volume misses is told by mesh_quality().
inline constexpr std::array<MeshCheck, 4> mesh_checks{too_few_layers, too_few_cells_to_twist, cells_too_flat,
                                                      patch_too_small};

/// What the mesh cannot hold, for a person.
std::vector<std::string> unsuitable(const MeshFacts& body);

}  // namespace myo::setup
