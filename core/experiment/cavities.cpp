#include "experiment/cavities.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>

#include "experiment/read_experiment.hpp"
#include "mesh/surface_topology.hpp"
#include "mesh/winding_number.hpp"

namespace myo::experiment {
namespace {

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

/// Area of all triangles of a surface [m2].
double area_of(const mesh::SurfaceMesh& surface) {
    double area = 0.0;
    for (const auto& corners : surface.triangles.colwise()) {
        const Eigen::Vector3d a = surface.vertices.col(corners(0)), b = surface.vertices.col(corners(1)),
                              c = surface.vertices.col(corners(2));
        area += 0.5 * (b - a).cross(c - a).norm();
    }
    return area;
}

/// The inner part of the surface that bounds the cavity around a point: the smallest one wound around it that faces
/// inward. Empty if there is none.
std::optional<std::size_t> part_around(const std::vector<mesh::SurfaceMesh>& parts, const Eigen::Vector3d& point) {
    std::optional<std::size_t> found;
    double smallest = 0.0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        // A part that faces inward winds -1 times around the points that it encloses.
        if (mesh::winding_number(parts[i], point) > -0.5) continue;
        const double volume = std::abs(mesh::enclosed_volume(parts[i]));
        if (found && volume >= smallest) continue;
        found = i;
        smallest = volume;
    }
    return found;
}

/// Why a point is in no cavity.
std::string no_cavity(const BodyQueries& body, const Eigen::Vector3d& point) {
    return mesh::bounding_box(body.surface().vertices).contains(point)
               ? "lies in no closed cavity: no inner part of the surface surrounds it, so it is outside the body or "
                 "the "
                 "cavity is open"
               : "lies outside the body";
}

/// Distance [m] along a ray at which it meets a surface next, more than `beyond` [m] from its start; empty if it does
/// not. `direction` is a unit vector.
std::optional<double> next_wall(const mesh::SurfaceMesh& surface, const Eigen::Vector3d& from,
                                const Eigen::Vector3d& direction, double beyond) {
    std::optional<double> nearest;
    for (const auto& corners : surface.triangles.colwise()) {
        // Intersection of a ray with a triangle by Cramer's rule (Möller & Trumbore 1997): `first` and `second` are the
        // barycentric coordinates of the hit, `along` its distance from the start of the ray.
        const Eigen::Vector3d a = surface.vertices.col(corners(0)), u = surface.vertices.col(corners(1)) - a,
                              v = surface.vertices.col(corners(2)) - a, p = direction.cross(v), s = from - a;
        const double determinant = u.dot(p);
        // The ray is parallel to the triangle, or the triangle has no area.
        if (determinant == 0.0) continue;
        const Eigen::Vector3d q = s.cross(u);
        const double along = v.dot(q) / determinant, first = s.dot(p) / determinant,
                     second = direction.dot(q) / determinant;
        if (first < 0.0 || second < 0.0 || first + second > 1.0 || along <= beyond) continue;
        nearest = std::min(nearest.value_or(along), along);
    }
    return nearest;
}

/// A point in the cavity that a part bounds: the middle between a wall and the one opposite. Empty if none is found.
std::optional<Eigen::Vector3d> point_in(const mesh::SurfaceMesh& wall, const BodyQueries& body) {
    for (const auto& corners : wall.triangles.colwise()) {
        const Eigen::Vector3d a = wall.vertices.col(corners(0)), b = wall.vertices.col(corners(1)),
                              c = wall.vertices.col(corners(2)), normal = (b - a).cross(c - a);
        if (!(normal.norm() > 0.0)) continue;
        // Walls of a cavity face away from the material, into the cavity.
        const Eigen::Vector3d from = (a + b + c) / 3.0;
        const std::optional<double> opposite = next_wall(body.surface(), from, normal.normalized(), body.tolerance());
        if (!opposite) continue;
        const Eigen::Vector3d middle = from + 0.5 * *opposite * normal.normalized();
        // Another wall may stand between, such as that of a body inside the cavity; then a further triangle is tried.
        if (mesh::winding_number(wall, middle) < -0.5 && !body.in_material(middle) &&
            body.distance_to_surface(middle) > body.tolerance())
            return middle;
    }
    return std::nullopt;
}

}  // namespace

std::vector<SurfaceCavity> surface_cavities(const BodyQueries& body) {
    std::vector<SurfaceCavity> cavities;
    const std::vector<mesh::SurfaceMesh> parts = closed_parts(body.surface());
    // A closed surface of one part faces outward and bounds no cavity.
    if (parts.size() < 2) return cavities;
    for (const mesh::SurfaceMesh& part : parts) {
        const double volume = mesh::enclosed_volume(part);
        if (volume >= 0.0) continue;
        if (const std::optional<Eigen::Vector3d> inside = point_in(part, body))
            cavities.push_back({{part, -volume, area_of(part)}, *inside});
    }
    return cavities;
}

Result<std::vector<Cavity>> chamber_cavities(const Experiment& experiment, const BodyQueries& body) {
    std::vector<Cavity> cavities;
    if (experiment.chambers.empty()) return cavities;
    const std::vector<mesh::SurfaceMesh> parts = closed_parts(body.surface());
    std::vector<std::size_t> taken;
    for (std::size_t i = 0; i < experiment.chambers.size(); ++i) {
        const Eigen::Vector3d& point = experiment.chambers[i].inside_m;
        const std::string key = "chamber[" + std::to_string(i) + "].inside_m";
        if (body.in_material(point) || body.distance_to_surface(point) <= body.tolerance())
            return declaration_error(experiment, key, "lies in the material; give a point in the cavity");
        const std::optional<std::size_t> part = part_around(parts, point);
        if (!part) return declaration_error(experiment, key, no_cavity(body, point));
        if (const auto same = std::find(taken.begin(), taken.end(), *part); same != taken.end())
            return declaration_error(experiment, key,
                                     "lies in the cavity of chamber \"" +
                                         experiment.chambers[static_cast<std::size_t>(same - taken.begin())].name +
                                         "\"; a cavity is one chamber");
        // Chambers of one cavity would have one pressure twice.
        taken.push_back(*part);
        cavities.push_back({parts[*part], std::abs(mesh::enclosed_volume(parts[*part])), area_of(parts[*part])});
    }
    return cavities;
}

}  // namespace myo::experiment
