#pragma once

#include <Eigen/Core>

#include <utility>
#include <vector>

#include "model/held_nodes.hpp"
#include "model/tendon.hpp"

namespace myo::test {

/// Guides at these points: the first stands still, the others move with the body.
inline std::vector<model::TendonGuide> guides_along(const mesh::VolumeMesh& mesh,
                                                    const std::vector<Eigen::Vector3d>& path) {
    const mesh::BoundaryLocator boundary(mesh);
    std::vector<model::TendonGuide> guides{{std::nullopt, path.front()}};
    for (std::size_t i = 1; i < path.size(); ++i)
        guides.push_back({fem::material_point(mesh, boundary, path[i]), path[i]});
    return guides;
}

/// Gives the model a body with the couplings of a tendon; returns the index of the first.
inline std::size_t couple_tendon(const std::vector<model::TendonGuide>& guides, bool by_shortening,
                                 model::Model& model) {
    const model::Body& body = *model.body;
    std::vector<std::vector<int>> couplings = body.couplings;
    const std::size_t first = couplings.size();
    for (std::vector<int>& group : model::tendon_couplings(guides, by_shortening))
        couplings.push_back(std::move(group));
    model.body = model::make_body(body.mesh, body.kind, model::held_nodes(body), std::move(couplings));
    return first;
}

/// Adds a tendon of prescribed tension [N].
inline void pull_by_tension(const std::vector<Eigen::Vector3d>& path, const fibre::Signal& tension_N,
                            model::Model& model, double friction = 0.0) {
    const std::vector<model::TendonGuide> guides = guides_along(model.body->mesh, path);
    const std::size_t first = couple_tendon(guides, false, model);
    model.force_elements.push_back(model::tendon_of_tension({guides, first, friction}, tension_N));
}

/// Adds an elastic tendon of prescribed shortening [m].
inline void pull_by_shortening(const std::vector<Eigen::Vector3d>& path, const fibre::Signal& shortening_m,
                               double stiffness_N_m, model::Model& model, double friction = 0.0) {
    const std::vector<model::TendonGuide> guides = guides_along(model.body->mesh, path);
    const std::size_t first = couple_tendon(guides, true, model);
    model.force_elements.push_back(
        model::tendon_of_shortening({guides, first, friction}, shortening_m, stiffness_N_m, 1e-5));
}

}  // namespace myo::test
