#include "model/body.hpp"

namespace myo::model {

BodyPointer make_body(mesh::VolumeMesh mesh, fem::ElementKind kind, const std::vector<int>& clamped_nodes,
                      std::vector<std::vector<int>> couplings) {
    auto body = std::make_shared<Body>();
    body->mesh = std::move(mesh);
    body->boundary = mesh::boundary_faces(body->mesh);
    body->kind = kind;
    body->incidence = node_incidence(body->mesh);
    body->clamped.assign(static_cast<std::size_t>(body->mesh.node_count()), false);
    for (const int node : clamped_nodes) body->clamped[static_cast<std::size_t>(node)] = true;
    body->surroundings = fem::cell_surroundings(body->mesh, body->clamped);
    body->cells = pack_elements(fem::make_elements(body->mesh, kind, body->surroundings));
    body->couplings = std::move(couplings);
    body->pattern = block_pattern(body->mesh, body->clamped, body->couplings);

    std::vector<Eigen::Triplet<double>> triplets;
    // Triplets of shared nodes are summed by setFromTriplets().
    for (const fem::MassEntry& entry : fem::consistent_mass(body->mesh))
        triplets.emplace_back(entry.row, entry.column, entry.value);
    body->unit_mass.resize(body->mesh.node_count(), body->mesh.node_count());
    body->unit_mass.setFromTriplets(triplets.begin(), triplets.end());
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

}  // namespace myo::model
