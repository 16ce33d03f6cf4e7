#include "model/body.hpp"

#include <map>

namespace myo::model {
namespace {

/// Adds the held axes of guided nodes to the clamped ones: each node once, and clamped if it cannot move at all.
void set_guided(const std::vector<GuidedNode>& guided, Body& body) {
    std::map<int, std::array<bool, 3>> held;
    for (const GuidedNode& node : guided)
        for (std::size_t axis = 0; axis < 3; ++axis) held[node.node][axis] |= node.held[axis];
    for (const auto& [node, axes] : held) {
        const auto i = static_cast<std::size_t>(node);
        if (axes[0] && axes[1] && axes[2]) body.clamped[i] = true;
        // A node of the clamp needs no guide.
        if (!body.clamped[i] && (axes[0] || axes[1] || axes[2])) body.guided.push_back({node, axes});
    }
}

}  // namespace

BodyPointer make_body(mesh::VolumeMesh mesh, fem::ElementKind kind, const std::vector<int>& clamped_nodes,
                      std::vector<std::vector<int>> couplings, const std::vector<GuidedNode>& guided) {
    auto body = std::make_shared<Body>();
    body->mesh = std::move(mesh);
    body->boundary = mesh::boundary_faces(body->mesh);
    body->kind = kind;
    body->incidence = node_incidence(body->mesh);
    body->clamped.assign(static_cast<std::size_t>(body->mesh.node_count()), false);
    for (const int node : clamped_nodes) body->clamped[static_cast<std::size_t>(node)] = true;
    set_guided(guided, *body);
    // After the clamp is complete: a clamped neighbour constrains the bending of a cell.
    body->surroundings = fem::cell_surroundings(body->mesh, body->clamped);
    body->cells = pack_elements(fem::make_elements(body->mesh, kind, body->surroundings));
    body->couplings = std::move(couplings);
    body->pattern = block_pattern(body->mesh, body->clamped, body->couplings, body->guided);

    std::vector<Eigen::Triplet<double>> triplets;
    // Triplets of shared nodes are summed by setFromTriplets().
    for (const fem::MassEntry& entry : fem::consistent_mass(body->mesh))
        triplets.emplace_back(entry.row, entry.column, entry.value);
    body->unit_mass.resize(body->mesh.node_count(), body->mesh.node_count());
    body->unit_mass.setFromTriplets(triplets.begin(), triplets.end());
    // Shape functions sum to 1, so the entries of the mass for density 1 sum to the volume.
    body->volume_m3 = body->unit_mass.sum();

    // The packed layout depends on the cell type, hence the visit.
    std::visit(
        [&](const auto& cells) {
            body->volume_points_per_cell = cells.volumes_per_cell();
            body->strains_per_cell = cells.strains_per_cell();
            body->points_per_cell = cells.points;
        },
        body->cells);
    return body;
}

Eigen::Matrix3Xd free_part(const Body& body, const Eigen::Matrix3Xd& field) {
    return scatter(body.pattern, gather(body.pattern, field));
}

}  // namespace myo::model
