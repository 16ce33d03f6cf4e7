#include "reproduce/chambered_arm.hpp"

#include <algorithm>

#include "material/catalogue.hpp"
#include "mesh/box_mesh.hpp"
#include "mesh/mesh_repair.hpp"
#include "mesh/region.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/surface_reader.hpp"

namespace myo::reproduce {
namespace {

using Eigen::Vector3d;

// Half width, outer limit of the chambers, half web, length and end caps of the plain arm [m].
constexpr double half = 22.2e-3, inner = 16.2e-3, web = 3e-3, length = 0.1, cap = 5e-3;
const Box walls{{-half, -half, 0.0}, {half, half, length}};

/// Hexahedra of the full block with edges of about `edge` [m], and grid planes at all walls, so that removed cells
/// leave exact chambers.
mesh::VolumeMesh grid_mesh(double edge) {
    return mesh::hex_mesh(
        mesh::grid_lines(walls, edge, {{{-inner, -web, web, inner}, {-inner, -web, web, inner}, {cap, length - cap}}}));
}

/// Whether a point lies in one of the four chambers.
bool in_chamber(const Vector3d& X) {
    const auto between = [](double a) { return std::abs(a) > web && std::abs(a) < inner; };
    return between(X(0)) && between(X(1)) && X(2) > cap && X(2) < length - cap;
}

/// The block without the cells of the chambers.
mesh::VolumeMesh plain_mesh(double edge) {
    mesh::VolumeMesh mesh = grid_mesh(edge);
    std::vector<int> kept;
    for (int c = 0; c < static_cast<int>(mesh.cell_count()); ++c)
        if (!in_chamber(mesh.nodes(Eigen::all, mesh.cells.col(c)).rowwise().mean())) kept.push_back(c);
    mesh.cells = mesh.cells(Eigen::all, kept).eval();
    return mesh::without_unused_nodes(mesh);
}

/// Model with the material of the paper, clamped at the top (z = 0.1 m), under gravity.
model::Model silicone(mesh::VolumeMesh mesh, fem::ElementKind kind) {
    const double top = mesh.nodes.row(2).maxCoeff();
    const std::vector<int> clamped = mesh::nodes_in_box(mesh, {{-1.0, -1.0, top - 1e-6}, {1.0, 1.0, top + 1e-6}});
    model::Model model;
    model.body = model::make_body(std::move(mesh), kind, clamped);
    model.material = material::find_material("neo_hookean");
    model.moduli = model::uniform_moduli(model.body->cell_count(), 263824.0, 0.499);
    model.density_kg_m3 = 1070.0;
    model.gravity_m_s2 = Vector3d(0.0, 0.0, -9.81);
    return model;
}

/// Midpoints of the four edges of the lower face: -x, +x, -y, +y.
measurement::MarkerSet face_points(const mesh::VolumeMesh& mesh) {
    const Box box = mesh::bounding_box(mesh.nodes);
    const Vector3d middle = 0.5 * (box.lowest + box.highest);
    const double z = box.lowest(2);
    return measurement::marker_set(mesh, {{box.lowest(0), middle(1), z},
                                          {box.highest(0), middle(1), z},
                                          {middle(0), box.lowest(1), z},
                                          {middle(0), box.highest(1), z}});
}

/// Tetrahedra of a closed surface in mm, with edges of about `edge` [m]. Errors: those of reader and mesher.
Result<mesh::VolumeMesh> file_mesh(const std::filesystem::path& file, double edge) {
    const Result<mesh::SurfaceMesh> read = mesh::read_surface(file, 1e-3);
    if (!read) return read.error();
    Result<setup::BodyMesh> meshed = setup::mesh_body(mesh::weld(*read),
                                                      {fem::ElementKind::tet10, edge, setup::Voxels::fitted}, {});
    if (!meshed) return meshed.error();
    return std::move(meshed->mesh);
}

}  // namespace

std::filesystem::path chamber_geometry_file(const ReproduceSettings& settings) {
    return settings.data / "data/geometry/arm_chambers.stl";
}

Result<ChamberedArm> make_chambered_arm(const ReproduceSettings& settings, double edge_m) {
    ChamberedArm arm;
    const bool own_file = std::filesystem::exists(chamber_geometry_file(settings));
    if (own_file) {
        Result<mesh::VolumeMesh> mesh = file_mesh(chamber_geometry_file(settings), edge_m);
        if (!mesh) return mesh.error();
        arm.model = silicone(std::move(*mesh), fem::ElementKind::tet10);
    } else {
        arm.model = silicone(plain_mesh(edge_m), fem::ElementKind::hex8);
    }
    const model::Body& body = *arm.model.body;
    // Closed cavities of the boundary are the chambers, in a file of the user as well.
    for (const std::vector<int>& chamber : model::closed_cavities(body)) {
        ++arm.chambers;
        // Sum of the faces' centres: its sign is that of the chamber's centre.
        double x = 0.0;
        for (const int face : chamber) x += body.mesh.nodes(Eigen::all, body.boundary.nodes.col(face)).row(0).mean();
        // Chambers with their centre at +x are pressurised.
        if (x > 0.0) arm.walls.insert(arm.walls.end(), chamber.begin(), chamber.end());
    }
    if (arm.walls.empty())
        return Error{"the body has no closed chamber at positive x", chamber_geometry_file(settings).string()};
    arm.points = face_points(body.mesh);
    return arm;
}

MuscleBody filled_arm(double edge_m, int muscles) {
    MuscleBody result;
    result.model = silicone(grid_mesh(edge_m), fem::ElementKind::hex8);
    auto fibres = std::make_shared<std::vector<fibre::FibreGroup>>();
    for (const double side : {1.0, -1.0}) {
        if (static_cast<int>(fibres->size()) == muscles) break;
        const Box box{{std::min(side * web, side * inner), -inner, cap},
                      {std::max(side * web, side * inner), inner, length - cap}};
        fibres->push_back(fibre::fibres_in_box(result.model.body->mesh, box, Vector3d::UnitZ(), 2e5,
                                               "muscle " + std::to_string(fibres->size() + 1)));
        result.model.activation.push_back(fibre::Signal::constant(1.0));
    }
    result.model.fibres = std::move(fibres);
    result.points = face_points(result.model.body->mesh);
    return result;
}

}  // namespace myo::reproduce
