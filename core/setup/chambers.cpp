#include "setup/chambers.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/text.hpp"
#include "experiment/cavities.hpp"
#include "experiment/read_experiment.hpp"
#include "mesh/winding_number.hpp"
#include "model/cavity_pressure.hpp"
#include "setup/default_mesh.hpp"
#include "setup/setting_words.hpp"

namespace myo::setup {
namespace {

using Eigen::Index;

/// Whether a closed surface encloses a point, whichever way its triangles face.
bool encloses(const mesh::SurfaceMesh& surface, const Eigen::Vector3d& point) {
    return std::abs(mesh::winding_number(surface, point)) > 0.5;
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

/// Sentence on a cavity that the cells of the mesh have filled, or opened to the outside.
std::string lost_cavity(const mesh::SurfaceMesh& surface, const mesh::SurfaceMesh& cavity, const BodyMesh& mesh) {
    return "the mesh with edges of " + format_number(1e3 * mesh.resolution_m, 3) +
           " mm has lost the closed cavity; choose edges of " + format_number(keeping_edge_m(surface, cavity), 2) +
           " m or less (" + edge_setting + "), or tetrahedra, which meet its walls";
}

}  // namespace

Result<std::vector<Chamber>> find_chambers(const experiment::Experiment& experiment, const mesh::SurfaceMesh& surface,
                                           const BodyMesh& mesh, const model::Body& body) {
    const Result<std::vector<experiment::Cavity>> declared = experiment::chamber_cavities(
        experiment, experiment::BodyQueries(surface));
    if (!declared) return declared.error();
    std::vector<Chamber> chambers;
    if (declared->empty()) return chambers;
    const std::vector<std::vector<int>> cavities = model::closed_cavities(body);
    for (std::size_t i = 0; i < declared->size(); ++i) {
        const experiment::Cavity& cavity = (*declared)[i];
        const experiment::ChamberDeclaration& chamber_of = experiment.chambers[i];
        const std::optional<std::size_t> found = cavity_on_mesh(body, cavities, cavity.wall,
                                                                point_on_mesh(mesh, chamber_of.inside_m));
        // Voxels fill a cavity or break its wall if they are as large as either.
        if (!found)
            return experiment::declaration_error(experiment, "chamber[" + std::to_string(i) + "].inside_m",
                                                 lost_cavity(surface, cavity.wall, mesh));
        Chamber chamber{chamber_of.name, cavities[*found]};
        // Volumes and areas are those of the declaration; the mesh's are kept to correct and to judge them.
        chamber.volume_m3 = cavity.volume_m3;
        chamber.wall_area_m2 = cavity.area_m2;
        chamber.mesh_area_m2 = model::wall_area(body, chamber.walls, body.mesh.nodes);
        const double meshed = model::cavity_volume(body, chamber.walls, body.mesh.nodes);
        // Walls that meet the surface are left as they are, to the last bit.
        if (std::abs(meshed / cavity.volume_m3 - 1.0) > chamber_policy.same_volume)
            chamber.volume_factor = cavity.volume_m3 / meshed;
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
