#include "setup/chambers.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/text.hpp"
#include "experiment/check_body.hpp"
#include "experiment/read_experiment.hpp"
#include "mesh/surface_topology.hpp"
#include "mesh/winding_number.hpp"
#include "model/cavity_pressure.hpp"
#include "setup/default_mesh.hpp"
#include "setup/setting_words.hpp"

namespace myo::setup {
namespace {

using Eigen::Index;

bool encloses(const mesh::SurfaceMesh& surface, const Eigen::Vector3d& point) {
    return std::abs(mesh::winding_number(surface, point)) > 0.5;
}

/// The edge-connected parts of a surface.
std::vector<mesh::SurfaceMesh> parts_of(const mesh::SurfaceMesh& surface) {
    const mesh::SurfaceTopology topology = mesh::surface_topology(surface);
    std::vector<std::vector<int>> triangles(static_cast<std::size_t>(topology.parts));
    for (Index t = 0; t < surface.triangles.cols(); ++t)
        triangles[static_cast<std::size_t>(topology.part[static_cast<std::size_t>(t)])].push_back(static_cast<int>(t));
    std::vector<mesh::SurfaceMesh> parts;
    for (const std::vector<int>& part : triangles)
        parts.push_back({surface.vertices, surface.triangles(Eigen::all, part)});
    return parts;
}

/// A cavity of the declared surface, by its part.
struct Cavity {
    std::size_t part = 0;
    double volume_m3 = 0.0;
    double area_m2 = 0.0;
};

double area_of(const mesh::SurfaceMesh& surface) {
    double area = 0.0;
    for (const auto& corners : surface.triangles.colwise()) {
        const Eigen::Vector3d a = surface.vertices.col(corners(0)), b = surface.vertices.col(corners(1)),
                              c = surface.vertices.col(corners(2));
        area += 0.5 * (b - a).cross(c - a).norm();
    }
    return area;
}

/// The smallest part around the point is the wall of its cavity; an even number of parts around it means a cavity.
Result<Cavity> declared_cavity(const experiment::Experiment& experiment, const std::string& key,
                               const std::vector<mesh::SurfaceMesh>& parts, const Eigen::Vector3d& inside) {
    int around = 0;
    Cavity cavity{0, std::numeric_limits<double>::infinity()};
    for (std::size_t p = 0; p < parts.size(); ++p) {
        if (!encloses(parts[p], inside)) continue;
        ++around;
        const double volume = std::abs(mesh::enclosed_volume(parts[p]));
        if (volume < cavity.volume_m3) cavity = {p, volume};
    }
    if (around > 0) cavity.area_m2 = area_of(parts[cavity.part]);
    if (around % 2 == 1)
        return experiment::declaration_error(
            experiment, key, "the point lies in the material, not in a cavity; give a point of the chamber's air");
    if (around == 0)
        return experiment::declaration_error(
            experiment, key,
            "the point lies outside the body, or in a cavity that is not closed; a chamber's walls must be a closed "
            "inner part of the surface");
    return cavity;
}

/// Triangles of the walls, quadrilaterals in halves; curved faces by their corners.
mesh::SurfaceMesh wall_surface(const model::Body& body, const std::vector<int>& walls) {
    const bool quads = body.boundary.nodes.rows() == 4;
    mesh::SurfaceMesh surface{body.mesh.nodes, Eigen::Matrix3Xi(3, static_cast<Index>(walls.size()) * (quads ? 2 : 1))};
    Index t = 0;
    for (const int wall : walls) {
        const auto nodes = body.boundary.nodes.col(wall);
        surface.triangles.col(t++) << nodes(0), nodes(1), nodes(2);
        if (quads) surface.triangles.col(t++) << nodes(0), nodes(2), nodes(3);
    }
    return surface;
}

/// Mean position of the walls' nodes.
Eigen::Vector3d middle_of(const model::Body& body, const std::vector<int>& walls) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const int wall : walls)
        middle += body.mesh.nodes(Eigen::all, body.boundary.nodes.col(wall)).rowwise().mean() /
                  static_cast<double>(walls.size());
    return middle;
}

/// The mesh's cavity around the point. Coarse voxels may fill the point itself: then the cavity whose middle lies in
/// the declared one.
std::optional<std::size_t> cavity_on_mesh(const model::Body& body, const std::vector<std::vector<int>>& cavities,
                                          const mesh::SurfaceMesh& declared, const Eigen::Vector3d& inside) {
    for (std::size_t c = 0; c < cavities.size(); ++c)
        if (encloses(wall_surface(body, cavities[c]), inside)) return c;
    for (std::size_t c = 0; c < cavities.size(); ++c)
        if (encloses(declared, middle_of(body, cavities[c]))) return c;
    return std::nullopt;
}

/// Edge length that keeps a cavity and the walls around it.
double keeping_edge_m(const mesh::SurfaceMesh& surface, mesh::SurfaceMesh cavity) {
    // Outward for the air, so that the thickness is that of the cavity.
    if (mesh::enclosed_volume(cavity) < 0.0) cavity.triangles.row(1).swap(cavity.triangles.row(2));
    return std::min(local_thickness(surface), local_thickness(cavity)) / chamber_policy.edges_per_width;
}

std::string lost_cavity(const mesh::SurfaceMesh& surface, const mesh::SurfaceMesh& cavity, const BodyMesh& mesh) {
    return "the mesh with edges of " + format_number(1e3 * mesh.resolution_m, 3) +
           " mm has lost the closed cavity; choose edges of " + format_number(keeping_edge_m(surface, cavity), 2) +
           " m or less (" + edge_setting + "), or tetrahedra, which meet its walls";
}

}  // namespace

Result<std::vector<Chamber>> find_chambers(const experiment::Experiment& experiment, const mesh::SurfaceMesh& surface,
                                           const BodyMesh& mesh, const model::Body& body) {
    std::vector<Chamber> chambers;
    if (experiment.chambers.empty()) return chambers;
    const std::vector<mesh::SurfaceMesh> parts = parts_of(surface);
    const std::vector<std::vector<int>> cavities = model::closed_cavities(body);
    std::vector<std::size_t> taken;
    for (std::size_t i = 0; i < experiment.chambers.size(); ++i) {
        const experiment::ChamberDeclaration& declared = experiment.chambers[i];
        const std::string key = "chamber[" + std::to_string(i) + "].inside_m";
        const Result<Cavity> cavity = declared_cavity(experiment, key, parts, declared.inside_m);
        if (!cavity) return cavity.error();
        const auto same = std::find(taken.begin(), taken.end(), cavity->part);
        if (same != taken.end())
            return experiment::declaration_error(
                experiment, key,
                "the point lies in the cavity of chamber " +
                    experiment.chambers[static_cast<std::size_t>(same - taken.begin())].name +
                    "; a cavity is one chamber");
        taken.push_back(cavity->part);
        const std::optional<std::size_t> found = cavity_on_mesh(body, cavities, parts[cavity->part],
                                                                point_on_mesh(mesh, declared.inside_m));
        if (!found)
            return experiment::declaration_error(experiment, key, lost_cavity(surface, parts[cavity->part], mesh));
        Chamber chamber{declared.name, cavities[*found]};
        chamber.volume_m3 = cavity->volume_m3;
        chamber.wall_area_m2 = cavity->area_m2;
        chamber.mesh_area_m2 = model::wall_area(body, chamber.walls, body.mesh.nodes);
        const double meshed = model::cavity_volume(body, chamber.walls, body.mesh.nodes);
        // Walls that meet the surface are left as they are, to the last bit.
        if (std::abs(meshed / cavity->volume_m3 - 1.0) > chamber_policy.same_volume)
            chamber.volume_factor = cavity->volume_m3 / meshed;
        chambers.push_back(std::move(chamber));
    }
    return chambers;
}

model::ForceElementPointer chamber_pressure(const model::Body& body, const Chamber& chamber,
                                            fibre::Signal pressure_Pa) {
    return model::cavity_pressure(body, chamber.walls, std::move(pressure_Pa), "chamber " + chamber.name,
                                  chamber.volume_factor);
}

double chamber_volume(const model::Body& body, const Chamber& chamber, const Eigen::Matrix3Xd& x) {
    return chamber.volume_factor * model::cavity_volume(body, chamber.walls, x);
}

}  // namespace myo::setup
