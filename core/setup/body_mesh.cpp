#include "setup/body_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/name_table.hpp"
#include "base/text.hpp"
#include "mesh/box_mesh.hpp"
#include "mesh/quality.hpp"
#include "mesh/region_facets.hpp"
#include "mesh/tet_mesh.hpp"
#include "mesh/voxel_mesh.hpp"
#include "setup/tetrahedra_surface.hpp"

namespace myo::setup {
namespace {

struct BodyMeshPolicy {
    /// Layers much thinner than an edge, between a face of the clamp and one of the body, can take a hundred times the
    /// cells. The estimate only decides whether the plain mesh is made for comparison; that mesh decides.
    double doubtful_growth = 2.5;
    double refused_growth = 4.0;
};
constexpr BodyMeshPolicy body_mesh_policy;

constexpr NameTable<Voxels, 2> voxel_kinds{{{
    {Voxels::fitted, "fitted"},
    {Voxels::truncated, "truncated"},
}}};

/// "100 x 30 x 30"
std::string size_in_mm(const Box& box) {
    const Eigen::Vector3d mm = 1e3 * box.size();
    return format_number(mm(0), 4) + " x " + format_number(mm(1), 4) + " x " + format_number(mm(2), 4);
}

// Grid planes at the faces of regions: clamp, supports and parts. Planes within 0.1 edges of an existing one or of the
// bounds are skipped: they would create slivers.
void add_region_planes(const std::vector<Box>& regions, const Box& bounds, double edge, mesh::GridPlanes& planes) {
    for (const Box& region : regions)
        for (int axis = 0; axis < 3; ++axis)
            for (const double p : {region.lowest(axis), region.highest(axis)}) {
                auto& list = planes[static_cast<std::size_t>(axis)];
                const bool inside = p > bounds.lowest(axis) + 0.1 * edge && p < bounds.highest(axis) - 0.1 * edge;
                const bool known = std::any_of(list.begin(), list.end(),
                                               [&](double q) { return std::abs(p - q) < 0.1 * edge; });
                if (inside && !known) list.push_back(p);
            }
}

/// Axes along which a region holds the highest face of the body and none holds the lowest.
std::array<bool, 3> held_at_highest(const std::vector<Box>& regions, const Box& bounds) {
    std::array<bool, 3> result{};
    for (std::size_t a = 0; a < 3; ++a) {
        const auto i = static_cast<Eigen::Index>(a);
        const bool high = std::any_of(regions.begin(), regions.end(),
                                      [&](const Box& r) { return r.highest(i) >= bounds.highest(i); });
        const bool low = std::any_of(regions.begin(), regions.end(),
                                     [&](const Box& r) { return r.lowest(i) <= bounds.lowest(i); });
        // A region at both ends fixes neither: the grid then starts at the lowest face.
        result[a] = high && !low;
    }
    return result;
}

// Whole cubes only. The grid starts at the held face, so the mesh shrinks at the free end and the support stays in
// place.
Result<mesh::VolumeMesh> truncated_mesh(const mesh::SurfaceMesh& surface, double edge, const std::vector<Box>& regions,
                                        const Progress& progress) {
    const Box bounds = mesh::bounding_box(surface.vertices);
    Result<mesh::GridLines> grid = mesh::whole_cube_lines(bounds, edge, held_at_highest(regions, bounds));
    if (!grid) return grid.error();
    if (mesh::is_box(surface)) return mesh::hex_mesh(*grid);
    mesh::VoxelOptions options;
    options.grid = std::move(*grid);
    return mesh::voxelize(surface, options, progress);
}

/// Warning about tetrahedra that cut through the faces of regions; `edge` in m.
std::string not_conforming(const std::string& reason, double edge) {
    return "the tetrahedra do not meet the faces of the declared boxes (" + reason +
           "): a clamp may hold up to a cell, " + format_number(1e3 * edge, 3) +
           " mm, less than declared, and a part have cells of mixed material; choose shorter edges (--resolution) or "
           "move the box";
}

/// Tetrahedra whose faces conform to the regions. If that fails or multiplies the number of cells, plain tetrahedra
/// with a warning.
Result<mesh::VolumeMesh> tetrahedral_mesh(const mesh::SurfaceMesh& declared, mesh::CellType type, double edge,
                                          const std::vector<Box>& regions, const Progress& progress,
                                          std::vector<std::string>& warnings) {
    const mesh::SizedSurface sized = surface_for_tetrahedra(declared, edge, progress);
    warnings.insert(warnings.end(), sized.notes.begin(), sized.notes.end());
    const mesh::SurfaceMesh& surface = sized.surface;
    mesh::TetOptions options;
    options.type = type;
    options.edge = edge;
    if (mesh::cut_by_regions(mesh::bounding_box(surface.vertices), regions, edge)) options.regions = regions;
    Result<mesh::VolumeMesh> mesh = mesh::tetrahedralize(surface, options, progress);
    // Without inner faces there is nothing that a plain mesh would do better.
    if (options.regions.empty() || progress.cancelled()) return mesh;
    // The estimate is cheap and usually shows that the regions cost little; only then is the second mesh saved.
    const auto count = [](const mesh::VolumeMesh& m) { return static_cast<double>(m.cell_count()); };
    if (mesh && count(*mesh) < body_mesh_policy.doubtful_growth * mesh::estimate_counts(surface, type, edge).cells)
        return mesh;
    options.regions.clear();
    Result<mesh::VolumeMesh> plain = mesh::tetrahedralize(surface, options, progress);
    if (mesh && (!plain || count(*mesh) < body_mesh_policy.refused_growth * count(*plain))) return mesh;
    if (!plain) return plain;
    const std::string reason = mesh ? "it would take " + format_number(count(*mesh) / count(*plain), 2) +
                                          " times the cells"
                                    : mesh.error().what;
    warnings.push_back(not_conforming(reason, edge));
    return plain;
}

/// Hexahedra that conform to the axis-aligned faces of the body and of the regions.
Result<mesh::VolumeMesh> fitted_mesh(const mesh::SurfaceMesh& surface, double edge, const mesh::EdgeAt& edge_at,
                                     const std::vector<Box>& regions, const Progress& progress) {
    const Box bounds = mesh::bounding_box(surface.vertices);
    mesh::GridPlanes planes;
    if (is_rectilinear(surface)) planes = face_planes(surface, edge);
    add_region_planes(regions, bounds, edge, planes);
    // A block needs no test of which cells lie inside.
    const std::optional<Box> box = mesh::is_box(surface);
    Result<mesh::GridLines> grid = mesh::limited_grid_lines(box.value_or(bounds), edge_at, planes);
    if (!grid) return grid.error();
    if (box) return mesh::hex_mesh(*grid);
    mesh::VoxelOptions options;
    options.grid = std::move(*grid);
    return mesh::voxelize(surface, options, progress);
}

}  // namespace

std::string to_string(Voxels voxels) { return voxel_kinds.name(voxels); }
std::vector<std::string> voxels_ids() { return voxel_kinds.names(); }
bool parse_voxels(const std::string& id, Voxels& voxels) { return voxel_kinds.find(id, voxels); }

Eigen::Vector3d point_on_mesh(const BodyMesh& mesh, const Eigen::Vector3d& declared_m) {
    if (!mesh.shrunk_from) return declared_m;
    const Box now = mesh::bounding_box(mesh.mesh.nodes);
    // Affine map between the bounding boxes, axis by axis: truncation shrinks each direction differently.
    const Eigen::Array3d scale = now.size().array() / mesh.shrunk_from->size().array();
    return now.lowest.array() + scale * (declared_m - mesh.shrunk_from->lowest).array();
}

Box box_on_mesh(const BodyMesh& mesh, const Box& declared) {
    return {point_on_mesh(mesh, declared.lowest), point_on_mesh(mesh, declared.highest)};
}

Box held_part(const Box& clamp, const Box& body) {
    Box part = clamp;
    for (int axis = 0; axis < 3; ++axis) {
        // A box that ends within 1 % of the extent inside the body selects the face; 1e-6 keeps its nodes despite
        // rounding.
        const double thin = 0.01 * body.size()(axis), beside = 1e-6 * body.size()(axis);
        const double low = body.lowest(axis), high = body.highest(axis);
        if (clamp.lowest(axis) <= low && clamp.highest(axis) >= low && clamp.highest(axis) < low + thin)
            part.highest(axis) = low + beside;
        if (clamp.highest(axis) >= high && clamp.lowest(axis) <= high && clamp.lowest(axis) > high - thin)
            part.lowest(axis) = high - beside;
    }
    return part;
}

Result<BodyMesh> mesh_body(const mesh::SurfaceMesh& surface, const MeshRequest& request,
                           const std::vector<Box>& regions, const Progress& progress) {
    BodyMesh result;
    result.element = request.element.value_or(automatic_element(surface));
    const mesh::CellType type = fem::cell_type(result.element);
    const double automatic_edge = automatic_resolution(surface, type);
    // A requested length equal to the automatic one means the automatic mesh, e.g. when a stored setting is passed
    // back.
    const bool automatic = !request.resolution_m || std::abs(*request.resolution_m / automatic_edge - 1.0) < 1e-9;
    result.resolution_m = request.refinement * request.resolution_m.value_or(automatic_edge);
    if (!(result.resolution_m > 0.0)) return Error{"the edge length must be positive", "--resolution"};
    const Box bounds = mesh::bounding_box(surface.vertices);
    const double edge = result.resolution_m;
    // Usually a length given in millimetres.
    if (edge > bounds.size().maxCoeff())
        return Error{"cells of " + format_number(1e3 * edge, 4) + " mm are larger than the body, " +
                         size_in_mm(bounds) + " mm; the number is in metres",
                     "--resolution"};
    const mesh::EdgeAt uniform = [=](int, double) { return edge; };
    const bool truncated = type == mesh::CellType::hex8 && request.voxels == Voxels::truncated;
    Result<mesh::VolumeMesh> mesh = type != mesh::CellType::hex8
                                        ? tetrahedral_mesh(surface, type, edge, regions, progress, result.warnings)
                                    : truncated ? truncated_mesh(surface, edge, regions, progress)
                                    : automatic
                                        ? fitted_mesh(surface, edge, automatic_edges(surface, request.refinement),
                                                      regions, progress)
                                        : fitted_mesh(surface, edge, uniform, regions, progress);
    if (!mesh) return mesh.error();
    result.mesh = std::move(*mesh);
    if (truncated) {
        result.shrunk_from = mesh::bounding_box(surface.vertices);
        result.warnings.push_back("truncated voxels: the body is meshed as " +
                                  size_in_mm(mesh::bounding_box(result.mesh.nodes)) + " mm instead of " +
                                  size_in_mm(*result.shrunk_from));
    }
    // Against the declared surface, so that volume that the mesh lacks is reported as well.
    for (const std::string& message : mesh::mesh_quality(result.mesh, &surface).messages)
        result.warnings.push_back(message);
    return result;
}

}  // namespace myo::setup
