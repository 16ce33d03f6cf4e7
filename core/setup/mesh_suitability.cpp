#include "setup/mesh_suitability.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "base/text.hpp"
#include "effect/catalogue.hpp"
#include "mesh/cell_topology.hpp"
#include "mesh/quality.hpp"
#include "setup/setting_words.hpp"

namespace myo::setup {
namespace {

/// Appended to advice if the automatic edge length is short enough.
constexpr const char* or_none = ", or leave it to the program";

/// Ending of the names of lengths.
constexpr std::string_view unit_ending = "_m";

constexpr const char* axis_names[] = {"x", "y", "z"};

/// Length with three digits, in mm as messages state lengths.
std::string in_mm(double metres) { return format_number(1e3 * metres, 3) + " mm"; }

bool has_hexahedra(const MeshFacts& facts) { return facts.mesh.mesh.type == mesh::CellType::hex8; }

/// Number of cells along the slice axis between its planes, from the distinct node coordinates.
int layers_in(const BodySlice& slice, const mesh::VolumeMesh& mesh) {
    std::vector<double> at;
    const double same = 1e-6 * slice.thickness_m();
    for (const double x : mesh.nodes.row(slice.axis))
        if (x > slice.low - same && x < slice.high + same) at.push_back(x);
    std::sort(at.begin(), at.end());
    at.erase(std::unique(at.begin(), at.end(), [&](double a, double b) { return b - a < same; }), at.end());
    return std::max(0, static_cast<int>(at.size()) - 1);
}

/// A slice with its number of layers.
struct Layers {
    BodySlice slice;
    int count = 0;
};

/// Thin slice with the fewest layers, of rods only or of all.
std::optional<Layers> fewest_layers(const MeshFacts& facts, bool rods) {
    std::optional<Layers> fewest;
    for (const BodySlice& slice : body_slices(facts.surface, facts.mesh.resolution_m)) {
        if (slice.thin_share < suitability_policy.min_part || (rods && !slice.thin_rod)) continue;
        const int count = layers_in(slice, facts.mesh.mesh);
        if (count > 0 && (!fewest || count < fewest->count)) fewest = Layers{slice, count};
    }
    return fewest;
}

/// "1 layer of hexahedra across 2 mm along z".
std::string layers_text(const Layers& layers) {
    return std::to_string(layers.count) + (layers.count == 1 ? " layer" : " layers") + " of hexahedra across " +
           in_mm(layers.slice.thickness_m()) + " along " + axis_names[layers.slice.axis];
}

/// Advice with the option of the command line and the place in the window; in m, as the option takes it.
std::string edges_up_to(double metres) {
    return "choose edges of " + format_number(metres, 3) + " m or less (" + edge_setting + ")";
}

/// Aspect ratio: longest over shortest edge of a hexahedron, longest edge over smallest height of a tetrahedron.
double aspect(const mesh::VolumeMesh& mesh, Eigen::Index cell) {
    const auto at = [&](int i) -> Eigen::Vector3d { return mesh.nodes.col(mesh.cells(i, cell)); };
    double longest = 0.0, shortest = std::numeric_limits<double>::infinity();
    const auto measure = [&](const auto& edges) {
        for (const auto& edge : edges) {
            const double length = (at(edge[0]) - at(edge[1])).norm();
            longest = std::max(longest, length), shortest = std::min(shortest, length);
        }
    };
    if (mesh.type == mesh::CellType::hex8) {
        measure(mesh::hexahedron_edges);
        return longest / shortest;
    }
    measure(mesh::tetrahedron_edges);
    double largest_face = 0.0;  // twice its area
    for (const auto& face : mesh::tetrahedron_faces)
        largest_face = std::max(largest_face, (at(face[1]) - at(face[0])).cross(at(face[2]) - at(face[0])).norm());
    // Smallest height = 3 V / largest face area = 6 V / (2 * area).
    const double six_volumes = std::abs((at(1) - at(0)).cross(at(2) - at(0)).dot(at(3) - at(0)));
    return longest * largest_face / six_volumes;
}

}  // namespace

std::optional<std::string> too_few_layers(const MeshFacts& facts) {
    const SuitabilityPolicy& policy = suitability_policy;
    if (has_hexahedra(facts) && is_rectilinear(facts.surface)) {
        const std::optional<Layers> fewest = fewest_layers(facts, false);
        if (!fewest || fewest->count >= policy.min_layers) return std::nullopt;
        return layers_text(*fewest) + ", fewer than " + std::to_string(policy.min_layers) +
               ": it may bend tens of percent too far and twist " + format_number(policy.layer_twist_error_percent) +
               " % too little; " + edges_up_to(fewest->slice.thickness_m() / policy.min_layers) + or_none;
    }
    // Bodies without axis-aligned faces have no countable layers: edge length against local thickness instead.
    const double thickness = local_thickness(facts.surface);
    const double edge = has_hexahedra(facts) ? facts.mesh.resolution_m : mesh::mean_edge_length(facts.mesh.mesh);
    const double most = has_hexahedra(facts) ? 1.0 / policy.min_layers : mesh_policy.edge_over_thickness;
    if (!(edge > 1.001 * most * thickness)) return std::nullopt;  // meshers slightly exceed the requested length
    return "edges of " + in_mm(edge) + " are longer than " + format_number(most, 3) +
           " times the body's thickness of " + in_mm(thickness) + ": it may bend too far; " +
           edges_up_to(most * thickness);
}

std::optional<std::string> too_few_cells_to_twist(const MeshFacts& facts) {
    const SuitabilityPolicy& policy = suitability_policy;
    if (!has_hexahedra(facts)) {
        const double thickness = local_thickness(facts.surface), edge = mesh::mean_edge_length(facts.mesh.mesh);
        const double best = longest_edge(facts.surface, thickness);
        // `best` exceeds the thickness unless the body is a rod, see longest_edge().
        if (best > thickness || edge < policy.rod_edge_over_thickness * thickness) return std::nullopt;
        return "edges of " + in_mm(edge) + " leave one layer of tetrahedra across a rod of " + in_mm(thickness) +
               ": its torsion may be off by " + format_number(policy.tetrahedral_rod_twist_error_percent) + " %; " +
               edges_up_to(best) + or_none;
    }
    const std::optional<Layers> fewest = fewest_layers(facts, true);
    if (!fewest || fewest->count >= policy.min_rod_layers) return std::nullopt;
    return layers_text(*fewest) + " of a rod, fewer than " + std::to_string(policy.min_rod_layers) +
           ": its torsion may be off by " + format_number(policy.rod_twist_error_percent) + " %; " +
           edges_up_to(fewest->slice.thickness_m() / policy.min_rod_layers) + or_none;
}

std::optional<std::string> cells_too_flat(const MeshFacts& facts) {
    const mesh::VolumeMesh& mesh = facts.mesh.mesh;
    // Single flat cells are harmless; a warning needs a share of them.
    double worst = 0.0;
    Eigen::Index flat = 0;
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) {
        const double own = aspect(mesh, c);
        worst = std::max(worst, own);
        flat += own > suitability_policy.max_aspect;
    }
    if (static_cast<double>(flat) < suitability_policy.min_flat_share * static_cast<double>(mesh.cell_count()))
        return std::nullopt;
    if (flat == 0) return std::nullopt;
    return std::to_string(flat) + " of " + std::to_string(mesh.cell_count()) + " cells are longer than " +
           format_number(suitability_policy.max_aspect) + " times their height, up to " + format_number(worst, 3) +
           " times: choose shorter edges (" + edge_setting + "), or move faces that nearly touch";
}

std::optional<std::string> effect_too_small(const MeshFacts& facts) {
    const double edge = mesh::mean_edge_length(facts.mesh.mesh);
    for (const effect::EffectDeclaration& effect : facts.effects) {
        const effect::Effect* const entry = effect::find_effect(effect);
        // Most effects declare no length: has() is false for an empty name.
        if (entry == nullptr || !effect::has(effect.parameters, entry->resolved_length)) continue;
        const double length = effect::number(effect.parameters, entry->resolved_length);
        if (length >= suitability_policy.min_cells_per_length * edge) continue;
        const std::string word = entry->resolved_length.substr(0, entry->resolved_length.size() - unit_ending.size());
        return "effect " + effect.id + ": its " + word + " of " + in_mm(length) +
               " is below the mesh's edge length of " + in_mm(edge) + ", so the cells see little of it; " +
               edges_up_to(length);
    }
    return std::nullopt;
}

std::optional<std::string> chamber_of_stairs(const MeshFacts& facts) {
    if (facts.chambers == nullptr) return std::nullopt;
    for (const Chamber& chamber : *facts.chambers) {
        const double stairs = chamber.mesh_area_m2 / chamber.wall_area_m2;
        if (stairs <= suitability_policy.max_chamber_area) continue;
        return "chamber " + chamber.name + ": edges of " + in_mm(facts.mesh.resolution_m) +
               " make stairs of its walls, whose area is " + format_number(stairs, 2) +
               " times the declared one: it may move " + format_number(suitability_policy.chamber_error_percent) +
               " % too far; choose tetrahedra, which meet its walls";
    }
    return std::nullopt;
}

WallLayers wall_layers(const MeshFacts& facts) {
    if (has_hexahedra(facts) && is_rectilinear(facts.surface))
        if (const std::optional<Layers> fewest = fewest_layers(facts, false))
            return {static_cast<double>(fewest->count), fewest->slice.thickness_m()};
    const double thickness = local_thickness(facts.surface);
    return {thickness / mesh::mean_edge_length(facts.mesh.mesh), thickness};
}

std::vector<std::string> unsuitable(const MeshFacts& facts) {
    std::vector<std::string> found;
    if (facts.mesh.mesh.cell_count() == 0) return found;
    for (const MeshCheck check : mesh_checks)
        if (std::optional<std::string> message = check(facts)) found.push_back(std::move(*message));
    return found;
}

}  // namespace myo::setup
