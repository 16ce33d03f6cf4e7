#include "setup/obstacles.hpp"

#include <algorithm>
#include <cmath>

#include "model/loaded_face.hpp"

namespace myo::setup {
namespace {

/// Distance of a point from an obstacle [m], positive outside. Edges of boxes are rounded, so that the normal is
/// continuous there.
model::DistanceField distance_from(const experiment::ObstacleDeclaration& obstacle, double edge_m) {
    using Declared = experiment::ObstacleDeclaration;
    if (const auto* plane = std::get_if<Declared::Plane>(&obstacle.shape))
        return model::plane_distance(plane->point_m, plane->normal);
    if (const auto* sphere = std::get_if<Declared::Sphere>(&obstacle.shape))
        return model::sphere_distance(sphere->centre_m, sphere->radius_m);
    const Box& box = std::get<Box>(obstacle.shape);
    return model::box_distance(
        box.lowest, box.highest,
        std::min(contact_policy.rounding * edge_m, contact_policy.max_rounding * box.size().minCoeff()));
}

}  // namespace

std::vector<model::ForceElementPointer> obstacle_contacts(const experiment::Experiment& experiment,
                                                          const model::Body& body) {
    // Mean edge of a cell: the stiffness follows the mesh, so that the penetration is a fixed share of a cell.
    const double edge_m = std::cbrt(body.volume_m3 / static_cast<double>(body.cell_count()));
    model::ContactLaw law;
    law.stiffness_Pa_m = contact_policy.stiffness * experiment.material.youngs_modulus_Pa / edge_m;
    law.onset_m = contact_policy.onset * edge_m;
    law.v0_m_s = contact_policy.v0_m_s;
    law.static_slip_m = contact_policy.static_slip * edge_m;
    // Without a clamp, sliding along an obstacle without friction would leave the stiffness of statics singular.
    if (experiment::clamped_boxes(experiment).empty())
        law.static_bed_Pa_m = contact_policy.static_bed * law.stiffness_Pa_m;
    std::vector<model::ForceElementPointer> contacts;
    for (const experiment::ObstacleDeclaration& obstacle : experiment.obstacles) {
        // Friction is the only number that obstacles declare; all others follow from body and mesh.
        law.friction = obstacle.friction;
        contacts.push_back(model::contact(body, model::free_faces(body), distance_from(obstacle, edge_m), law));
    }
    return contacts;
}

}  // namespace myo::setup
