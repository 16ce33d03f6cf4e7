#include "effect/changed_body.hpp"

#include <utility>

#include "model/held_nodes.hpp"

namespace myo::effect {
// Cells and shapes are unchanged: only the unknowns and their sparsity pattern are rebuilt.
model::BodyPointer released_body(const model::Body& body, const std::vector<int>& nodes) {
    auto released = std::make_shared<model::Body>(body);
    for (const int node : nodes) released->clamped[static_cast<std::size_t>(node)] = false;
    released->pattern = model::block_pattern(released->mesh, released->clamped, released->couplings, released->guided);
    return released;
}

// Mass, gradients and volumes depend on the nodes: the body is rebuilt.
model::BodyPointer on_nodes(const model::Body& body, Eigen::Matrix3Xd nodes_m) {
    mesh::VolumeMesh mesh = body.mesh;
    mesh.nodes = std::move(nodes_m);
    return model::make_body(std::move(mesh), body.kind, model::held_nodes(body), body.couplings, body.guided);
}

model::BodyPointer of_kind(const model::Body& body, fem::ElementKind kind) {
    return model::make_body(body.mesh, kind, model::held_nodes(body), body.couplings, body.guided);
}

}  // namespace myo::effect
