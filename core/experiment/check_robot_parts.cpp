#include "experiment/check_robot_parts.hpp"

#include <cmath>
#include <optional>

#include "experiment/read_experiment.hpp"
#include "mesh/surface_topology.hpp"
#include "mesh/winding_number.hpp"

namespace myo::experiment {
namespace {

std::string robot_key(const char* table, std::size_t index, const char* key) {
    return std::string(table) + "[" + std::to_string(index) + "]." + key;
}

/// Closed parts of a surface, one mesh each with the vertices of the whole.
std::vector<mesh::SurfaceMesh> closed_parts(const mesh::SurfaceMesh& surface) {
    const mesh::SurfaceTopology topology = mesh::surface_topology(surface);
    std::vector<std::vector<int>> triangles(static_cast<std::size_t>(topology.parts));
    for (std::size_t t = 0; t < topology.part.size(); ++t)
        triangles[static_cast<std::size_t>(topology.part[t])].push_back(static_cast<int>(t));
    std::vector<mesh::SurfaceMesh> parts;
    for (const std::vector<int>& part : triangles)
        parts.push_back({surface.vertices, surface.triangles(Eigen::all, part)});
    return parts;
}

/// The inner part of the surface that bounds the cavity around a point: the smallest one wound around it that faces
/// inward. Empty if there is none.
std::optional<std::size_t> cavity_around(const std::vector<mesh::SurfaceMesh>& parts, const Eigen::Vector3d& point) {
    std::optional<std::size_t> found;
    double smallest = 0.0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (mesh::winding_number(parts[i], point) > -0.5) continue;
        const double volume = std::abs(mesh::enclosed_volume(parts[i]));
        if (found && volume >= smallest) continue;
        found = i;
        smallest = volume;
    }
    return found;
}

Result<void> check_chambers(const Experiment& experiment, const BodyQueries& body) {
    if (experiment.chambers.empty()) return {};
    const std::vector<mesh::SurfaceMesh> parts = closed_parts(body.surface());
    std::vector<std::size_t> cavities;
    for (std::size_t i = 0; i < experiment.chambers.size(); ++i) {
        const Eigen::Vector3d& point = experiment.chambers[i].inside_m;
        const std::string key = robot_key("chamber", i, "inside_m");
        if (body.in_material(point) || body.distance_to_surface(point) <= body.tolerance())
            return declaration_error(experiment, key, "lies in the material; give a point in the cavity");
        const std::optional<std::size_t> cavity = cavity_around(parts, point);
        if (!cavity && !mesh::bounding_box(body.surface().vertices).contains(point))
            return declaration_error(experiment, key, "lies outside the body");
        if (!cavity)
            return declaration_error(experiment, key,
                                     "lies in no closed cavity: no inner part of the surface surrounds it, so it is "
                                     "outside the body or the cavity is open");
        for (std::size_t j = 0; j < i; ++j)
            if (cavities[j] == *cavity)
                return declaration_error(
                    experiment, key,
                    "lies in the cavity of chamber \"" + experiment.chambers[j].name + "\"; a cavity is one chamber");
        cavities.push_back(*cavity);
    }
    return {};
}

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
        return (plane->normal.transpose() * from_plane).minCoeff() < -2.0 * body.tolerance();
    }
    if (const auto* sphere = std::get_if<ObstacleDeclaration::Sphere>(&obstacle.shape))
        return body.in_material(sphere->centre_m) ||
               body.distance_to_surface(sphere->centre_m) < sphere->radius_m - 2.0 * body.tolerance();
    return body.holds_volume(std::get<Box>(obstacle.shape));
}

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
    if (experiment.clamp_box_m.contains(guide_m)) return false;
    return body.in_material(guide_m) ||
           body.distance_to_surface(guide_m) <= experiment.markers.max_standoff_m + body.tolerance();
}

Result<void> check_robot_parts_on_body(const Experiment& experiment, const BodyQueries& body) {
    for (const auto& check : {check_chambers, check_tendons, check_parts, check_obstacles})
        if (Result<void> fits = check(experiment, body); !fits) return fits;
    return {};
}

}  // namespace myo::experiment
