#include "effect/changed_body.hpp"

#include <utility>

#include "model/held_nodes.hpp"

namespace myo {
BodyPointer released_body(const Body& body, const std::vector<int>& nodes) {
    auto released = std::make_shared<Body>(body);
    for (const int node : nodes) released->clamped[static_cast<std::size_t>(node)] = false;
    released->pattern = block_pattern(released->mesh, released->clamped);
    return released;
}

BodyPointer on_nodes(const Body& body, Eigen::Matrix3Xd nodes_m) {
    VolumeMesh mesh = body.mesh;
    mesh.nodes = std::move(nodes_m);
    return make_body(std::move(mesh), body.kind, held_nodes(body));
}

BodyPointer of_kind(const Body& body, ElementKind kind) { return make_body(body.mesh, kind, held_nodes(body)); }

}  // namespace myo
