#include "experiment/check_robot_parts.hpp"

#include "experiment/cavities.hpp"
#include "experiment/read_experiment.hpp"
#include "toml/toml_path.hpp"

namespace myo::experiment {
namespace {

/// Key of an entry in messages: "tendon[1].path_m".
std::string robot_key(const char* table, std::size_t index, const char* key) {
    return toml::element_text(table, index) + "." + key;
}

/// Cavities are searched again where chambers are put on the mesh; here they are searched to report errors early.
Result<void> check_chambers(const Experiment& experiment, const BodyQueries& body) {
    const Result<std::vector<Cavity>> cavities = chamber_cavities(experiment, body);
    return cavities ? Result<void>() : cavities.error();
}

/// A tendon between guides that all stand still has a constant length and does no work on the body.
Result<void> check_tendons(const Experiment& experiment, const BodyQueries& body) {
    for (std::size_t i = 0; i < experiment.tendons.size(); ++i) {
        bool any = false;
        for (const auto& guide : experiment.tendons[i].path_m.colwise())
            any = any || guide_moves(experiment, body, guide);
        if (!any)
            return declaration_error(experiment, robot_key("tendon", i, "path_m"),
                                     "all guides stand still, in the clamp box or off the body: it moves nothing");
    }
    return {};
}

/// Parts without volume would get no cell. Files and regions are checked on the mesh.
Result<void> check_parts(const Experiment& experiment, const BodyQueries& body) {
    for (std::size_t i = 0; i < experiment.parts.size(); ++i) {
        const Box* box = std::get_if<Box>(&experiment.parts[i].place);
        if (box != nullptr && !body.holds_volume(*box))
            return declaration_error(experiment, robot_key("part", i, "box_m"),
                                     "the box contains no material of the body");
    }
    return {};
}

/// True if the body reaches into an obstacle by more than the tolerance.
bool reaches_into(const BodyQueries& body, const ObstacleDeclaration& obstacle) {
    if (const auto* plane = std::get_if<ObstacleDeclaration::Plane>(&obstacle.shape)) {
        const Eigen::Matrix3Xd from_plane = body.surface().vertices.colwise() - plane->point_m;
        // A half-space reaches the body first at a vertex.
        return (plane->normal.transpose() * from_plane).minCoeff() < -2.0 * body.tolerance();
    }
    if (const auto* sphere = std::get_if<ObstacleDeclaration::Sphere>(&obstacle.shape))
        return body.in_material(sphere->centre_m) ||
               body.distance_to_surface(sphere->centre_m) < sphere->radius_m - 2.0 * body.tolerance();
    return body.holds_volume(std::get<Box>(obstacle.shape));
}

/// Contact would start with a force that has no cause if the body reached into an obstacle at rest.
Result<void> check_obstacles(const Experiment& experiment, const BodyQueries& body) {
    for (std::size_t i = 0; i < experiment.obstacles.size(); ++i)
        if (reaches_into(body, experiment.obstacles[i]))
            return declaration_error(experiment, "obstacle[" + std::to_string(i) + "]",
                                     "the body lies in it at rest; move the obstacle, or turn the normal of a plane "
                                     "towards the body");
    return {};
}

}  // namespace

bool guide_moves(const Experiment& experiment, const BodyQueries& body, const Eigen::Vector3d& guide_m) {
    // The clamped region stands still, so a guide in it does as well, even though it lies in the material.
    for (const Box& held : clamped_boxes(experiment))
        if (held.contains(guide_m)) return false;
    return body.in_material(guide_m) ||
           body.distance_to_surface(guide_m) <= experiment.markers.max_standoff_m + body.tolerance();
}

Result<void> check_robot_parts_on_body(const Experiment& experiment, const BodyQueries& body) {
    for (const auto& check : {check_chambers, check_tendons, check_parts, check_obstacles})
        if (Result<void> fits = check(experiment, body); !fits) return fits;
    return {};
}

}  // namespace myo::experiment
