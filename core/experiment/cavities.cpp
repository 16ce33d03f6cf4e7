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

}  // namespace

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
        taken.push_back(*part);
        cavities.push_back({parts[*part], std::abs(mesh::enclosed_volume(parts[*part])), area_of(parts[*part])});
    }
    return cavities;
}

}  // namespace myo::experiment
