#include "setup/default_mesh.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "mesh/quality.hpp"
#include "mesh/voxel_mesh.hpp"

namespace myo::setup {
namespace {

/// Axis that a triangle is normal to, or -1. Degenerate triangles without area give 3 and restrict nothing.
int normal_axis(const mesh::SurfaceMesh& surface, Eigen::Index t) {
    const auto corner = [&](int i) { return Eigen::Vector3d(surface.vertices.col(surface.triangles(i, t))); };
    const Eigen::Vector3d normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    const double area = normal.norm();
    const double edge = std::max((corner(1) - corner(0)).norm(), (corner(2) - corner(0)).norm());
    if (area <= 1e-9 * edge * edge) return 3;
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(normal(axis)) > (1.0 - 1e-6) * area) return axis;
    return -1;
}

/// Occupancy of the blocks between the face planes of a rectilinear body, x fastest.
class Blocks {
public:
    Blocks(const mesh::SurfaceMesh& surface, mesh::GridLines grid) : grid_(std::move(grid)), count_(grid_.cells()) {
        filled_.assign(static_cast<std::size_t>(count_.prod()), false);
        mesh::VoxelOptions options;
        options.grid = grid_;
        // Voxelising the grid of face planes classifies each block as inside or outside in one pass.
        const Result<mesh::VolumeMesh> mesh = mesh::voxelize(surface, options);
        if (!mesh) return;
        for (Eigen::Index c = 0; c < mesh->cell_count(); ++c) {
            const Eigen::Vector3d middle = mesh->nodes(Eigen::all, mesh->cells.col(c)).rowwise().mean();
            Eigen::Vector3i at;
            for (int a = 0; a < 3; ++a) {
                const std::vector<double>& lines = grid_.axis[static_cast<std::size_t>(a)];
                // A middle lies strictly between two lines, so the line above it numbers the block.
                at[a] = static_cast<int>(std::lower_bound(lines.begin(), lines.end(), middle[a]) - lines.begin()) - 1;
            }
            filled_[index(at)] = true;
        }
    }

    bool filled(const Eigen::Vector3i& at) const {
        return (at.array() >= 0).all() && (at.array() < count_.array()).all() && filled_[index(at)];
    }

    const Eigen::Vector3i& count() const { return count_; }
    const mesh::GridLines& grid() const { return grid_; }

    /// Whether both neighbours of a block along the axis are empty: the body is one block thick there.
    bool alone(const Eigen::Vector3i& at, int axis) const {
        const Eigen::Vector3i step = Eigen::Vector3i::Unit(axis);
        return !filled(at - step) && !filled(at + step);
    }

    double volume(const Eigen::Vector3i& at) const { return length(0, at[0]) * length(1, at[1]) * length(2, at[2]); }

    double length(int axis, int slice) const {
        const std::vector<double>& lines = grid_.axis[static_cast<std::size_t>(axis)];
        return lines[static_cast<std::size_t>(slice) + 1] - lines[static_cast<std::size_t>(slice)];
    }

private:
    std::size_t index(const Eigen::Vector3i& at) const {
        return static_cast<std::size_t>((at[2] * count_[1] + at[1]) * count_[0] + at[0]);
    }

    mesh::GridLines grid_;
    Eigen::Vector3i count_;
    std::vector<bool> filled_;
};

// Edge length before thin parts are considered: proportional to the cube root of the volume.
double plain_resolution(const mesh::SurfaceMesh& surface, mesh::CellType type) {
    const double per_size = type == mesh::CellType::hex8 ? mesh_policy.hexahedra_per_size
                                                         : mesh_policy.tetrahedra_per_size;
    return std::cbrt(mesh::enclosed_volume(surface)) / per_size;
}

// Edge length that gives the wanted number of layers across a slice.
double layer_edge(const BodySlice& slice) {
    return slice.thickness_m() / (slice.thin_rod ? mesh_policy.rod_layers : mesh_policy.min_layers);
}

// Flat cells: the edges in the plane may exceed the layer edge by max_aspect, within the limit of min_edge_share.
double hexahedra_resolution(double edge, const std::vector<BodySlice>& slices) {
    double thinnest = edge;
    for (const BodySlice& slice : slices)
        if (slice.thin_share >= mesh_policy.min_part && !slice.thin_rod)
            thinnest = std::min(thinnest, layer_edge(slice));
    return std::clamp(mesh_policy.max_aspect * thinnest, mesh_policy.min_edge_share * edge, edge);
}

/// Whether a block has so few layers along two axes that its torsional stiffness would be wrong.
bool is_rod(const Blocks& blocks, const Eigen::Vector3i& at, double edge, int one, int other) {
    if (!blocks.alone(at, one) || !blocks.alone(at, other)) return false;
    const double first = std::round(blocks.length(one, at[one]) / edge),
                 second = std::round(blocks.length(other, at[other]) / edge);
    return std::max(first, second) <= mesh_policy.few_rod_layers &&
           std::min(first, second) < mesh_policy.few_rod_layers;
}

/// Contribution of one block to the slice that contains it.
void add_block(const Blocks& blocks, const Eigen::Vector3i& at, double edge, double whole, BodySlice& slice) {
    const int b = (slice.axis + 1) % 3, c = (slice.axis + 2) % 3;
    // `across`: the rod's axis lies in the slice, so the slice is one of its two thin directions. `along`: the rod runs
    // along the slice axis. One block that is no rod resets rod_thickness_m to 0 for the slice.
    const bool across = is_rod(blocks, at, edge, slice.axis, b) || is_rod(blocks, at, edge, slice.axis, c);
    if (blocks.alone(at, slice.axis)) slice.thin_share += blocks.volume(at) / whole;
    slice.thin_rod = slice.thin_rod || across;
    const bool along = is_rod(blocks, at, edge, b, c) && !across;
    slice.rod_thickness_m = std::min(slice.rod_thickness_m,
                                     along ? std::min(blocks.length(b, at[b]), blocks.length(c, at[c])) : 0.0);
}

/// Area of a triangle [m2].
double area(const mesh::SurfaceMesh& surface, Eigen::Index t) {
    const Eigen::Vector3d a = surface.vertices.col(surface.triangles(0, t));
    return 0.5 * (surface.vertices.col(surface.triangles(1, t)) - a)
                     .cross(surface.vertices.col(surface.triangles(2, t)) - a)
                     .norm();
}

/// Area of the whole surface [m2].
double whole_area(const mesh::SurfaceMesh& surface) {
    double sum = 0.0;
    for (Eigen::Index t = 0; t < surface.triangles.cols(); ++t) sum += area(surface, t);
    return sum;
}

// The number of unknowns grows at most with the cube of the inverse edge length, so steps of 5 % end soon.
/// Edge length of tetrahedra [m]: short enough for the local thickness, unless that takes too many unknowns.
double tetrahedra_resolution(double edge, const mesh::SurfaceMesh& surface) {
    double shortest = std::min(edge, longest_edge(surface, local_thickness(surface)));
    const auto unknowns = [&](double e) { return mesh::estimate_counts(surface, mesh::CellType::tet10, e).dofs; };
    while (shortest < edge && unknowns(shortest) > mesh_policy.max_unknowns) shortest = std::min(edge, 1.05 * shortest);
    return shortest;
}

/// Distance along a ray to the nearest triangle beyond `skip` (Möller & Trumbore 1997); infinite if there is none.
double ray_length(const mesh::SurfaceMesh& surface, const Eigen::Vector3d& start, const Eigen::Vector3d& direction,
                  double skip) {
    double nearest = std::numeric_limits<double>::infinity();
    for (Eigen::Index t = 0; t < surface.triangles.cols(); ++t) {
        const Eigen::Vector3d a = surface.vertices.col(surface.triangles(0, t));
        const Eigen::Vector3d u = surface.vertices.col(surface.triangles(1, t)) - a;
        const Eigen::Vector3d v = surface.vertices.col(surface.triangles(2, t)) - a;
        const Eigen::Vector3d p = direction.cross(v);
        const double determinant = u.dot(p);
        if (determinant == 0.0) continue;
        const Eigen::Vector3d from = start - a, q = from.cross(u);
        const double s = from.dot(p) / determinant, r = direction.dot(q) / determinant,
                     distance = v.dot(q) / determinant;
        if (s >= 0.0 && r >= 0.0 && s + r <= 1.0 && distance > skip) nearest = std::min(nearest, distance);
    }
    return nearest;
}

}  // namespace

bool is_rectilinear(const mesh::SurfaceMesh& surface) {
    for (Eigen::Index t = 0; t < surface.triangles.cols(); ++t)
        if (normal_axis(surface, t) < 0) return false;
    return true;
}

mesh::GridPlanes face_planes(const mesh::SurfaceMesh& surface, double edge) {
    mesh::GridPlanes planes;
    for (Eigen::Index t = 0; t < surface.triangles.cols(); ++t) {
        const int axis = normal_axis(surface, t);
        if (axis < 0 || axis > 2) continue;
        planes[static_cast<std::size_t>(axis)].push_back(surface.vertices(axis, surface.triangles(0, t)));
    }
    for (std::vector<double>& list : planes) {
        std::sort(list.begin(), list.end());
        std::vector<double> distinct;
        // Nearly coincident faces would create cells of no thickness.
        for (const double p : list)
            if (distinct.empty() || p - distinct.back() > 0.01 * edge) distinct.push_back(p);
        list = std::move(distinct);
    }
    return planes;
}

std::vector<BodySlice> body_slices(const mesh::SurfaceMesh& surface, double edge) {
    std::vector<BodySlice> slices;
    if (!is_rectilinear(surface)) return slices;
    const Box bounds = mesh::bounding_box(surface.vertices);
    // The edge length exceeds the body, so the grid has one block between adjacent planes.
    const mesh::GridLines grid = mesh::grid_lines(bounds, 2.0 * bounds.size().maxCoeff(), face_planes(surface, edge));
    // A detailed rectilinear body can have more face planes than the block grid may hold; it is then meshed uniformly.
    if (grid.cells().cast<double>().prod() > mesh::box_mesh_policy.max_grid_cells) return slices;
    const Blocks blocks(surface, grid);
    const double whole = mesh::enclosed_volume(surface);
    for (int axis = 0; axis < 3; ++axis) {
        const std::vector<double>& lines = grid.axis[static_cast<std::size_t>(axis)];
        const int b = (axis + 1) % 3, c = (axis + 2) % 3;
        for (int i = 0; i < blocks.count()[axis]; ++i) {
            BodySlice slice{axis, lines[static_cast<std::size_t>(i)], lines[static_cast<std::size_t>(i) + 1]};
            slice.rod_thickness_m = std::numeric_limits<double>::infinity();
            // One pass over the filled blocks of the slice collects its thin share and its rods.
            for (int j = 0; j < blocks.count()[b]; ++j)
                for (int k = 0; k < blocks.count()[c]; ++k) {
                    Eigen::Vector3i at;
                    at[axis] = i, at[b] = j, at[c] = k;
                    if (blocks.filled(at)) add_block(blocks, at, edge, whole, slice);
                }
            if (std::isinf(slice.rod_thickness_m)) slice.rod_thickness_m = 0.0;
            slices.push_back(slice);
        }
    }
    return slices;
}

double local_thickness(const mesh::SurfaceMesh& surface) {
    // One ray per equal share of the area: large triangles send several rays, small ones one for many of them.
    const Eigen::Index count = surface.triangles.cols();
    const double whole = whole_area(surface);
    const double skip = 1e-6 * mesh::bounding_box(surface.vertices).size().norm();
    std::vector<double> lengths;
    double passed = 0.0;
    for (Eigen::Index t = 0; t < count; ++t) {
        // The cumulated area in units of area per ray; each whole unit that the triangle passes is one ray.
        const double before = std::floor(passed / whole * mesh_policy.thickness_rays);
        passed += area(surface, t);
        const int rays = static_cast<int>(std::floor(passed / whole * mesh_policy.thickness_rays) - before);
        if (rays == 0) continue;
        const Eigen::Vector3d a = surface.vertices.col(surface.triangles(0, t)),
                              b = surface.vertices.col(surface.triangles(1, t)),
                              c = surface.vertices.col(surface.triangles(2, t));
        // The ray starts on the surface, so hits closer than `skip` are the starting triangle itself or its neighbours.
        const double length = ray_length(surface, (a + b + c) / 3.0, -(b - a).cross(c - a).normalized(), skip);
        if (std::isfinite(length)) lengths.insert(lengths.end(), static_cast<std::size_t>(rays), length);
    }
    if (lengths.empty()) return std::numeric_limits<double>::infinity();
    const auto place = lengths.begin() + static_cast<std::ptrdiff_t>(mesh_policy.thickness_quantile *
                                                                     static_cast<double>(lengths.size()));
    std::nth_element(lengths.begin(), place, lengths.end());
    return *place;
}

double longest_edge(const mesh::SurfaceMesh& surface, double thickness_m) {
    // Surface times thickness over volume is about 2 for a plate and 4 for a rod (see MeshPolicy::min_rod_surface).
    const bool rod = whole_area(surface) * thickness_m > mesh_policy.min_rod_surface * mesh::enclosed_volume(surface);
    return (rod ? mesh_policy.rod_edge_over_thickness : mesh_policy.edge_over_thickness) * thickness_m;
}

fem::ElementKind automatic_element(const mesh::SurfaceMesh& surface) {
    return is_rectilinear(surface) ? fem::ElementKind::hex8 : fem::ElementKind::tet10;
}

double automatic_resolution(const mesh::SurfaceMesh& surface, mesh::CellType type) {
    const double edge = plain_resolution(surface, type);
    if (!(edge > 0.0)) return edge;  // nothing is enclosed: the mesher says so
    return type == mesh::CellType::hex8 ? hexahedra_resolution(edge, body_slices(surface, edge))
                                        : tetrahedra_resolution(edge, surface);
}

mesh::EdgeAt automatic_edges(const mesh::SurfaceMesh& surface, double refinement) {
    const double plain = plain_resolution(surface, mesh::CellType::hex8);
    // Slices are judged with the plain edge length, the same as in automatic_resolution(), so that both agree.
    const std::vector<BodySlice> slices = body_slices(surface, plain);
    const double edge = hexahedra_resolution(plain, slices);
    return [=](int axis, double at) {
        double own = edge;
        for (const BodySlice& slice : slices) {
            if (slice.axis != axis || at < slice.low || at > slice.high) continue;
            if (slice.thin_share > 0.0) own = std::min(own, layer_edge(slice));
            if (slice.rod_thickness_m > 0.0)
                // Along rods the edges may be longer: bending varies slowly there.
                own = std::max(own, mesh_policy.rod_aspect * slice.rod_thickness_m / mesh_policy.rod_layers);
        }
        return refinement * own;
    };
}

}  // namespace myo::setup
