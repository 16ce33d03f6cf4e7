#include "mesh/voxel_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/text.hpp"
#include "mesh/mesh_repair.hpp"
#include "mesh/surface_topology.hpp"

namespace myo::mesh {
namespace {

struct VoxelMeshPolicy {
    int rays_per_axis = 4;  // 16 rays per column of cells
};
constexpr VoxelMeshPolicy voxel_mesh_policy;

/// Intersection of a ray with the surface.
struct Crossing {
    double z = 0.0;
    int turn = 0;  // +1 where the ray enters an outward surface, -1 where it leaves
};

// Positions of the rays along one axis. A shift of a few millionths of a cell keeps rays off the edges and diagonals of
// surfaces drawn on the same grid. The shift is constant, so the result is reproducible.
std::vector<double> ray_positions(const std::vector<double>& lines, double shift) {
    std::vector<double> positions;
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
        for (int s = 0; s < voxel_mesh_policy.rays_per_axis; ++s) {
            positions.push_back(lines[i] +
                                (lines[i + 1] - lines[i]) * ((s + 0.5) / voxel_mesh_policy.rays_per_axis + shift));
        }
    }
    return positions;
}

// Side of the edge a-b on which the point lies. Evaluated from the lower to the higher vertex number, so that both
// triangles of an edge agree and no ray passes between them.
bool left_of(const Eigen::Matrix3Xd& x, int a, int b, double px, double py) {
    const bool swapped = a > b;
    if (swapped) std::swap(a, b);
    const double side = (x(0, b) - x(0, a)) * (py - x(1, a)) - (x(1, b) - x(1, a)) * (px - x(0, a));
    return (side >= 0.0) != swapped;
}

/// Intersections of a grid of rays along z with the surface.
class RayField {
public:
    RayField(const SurfaceMesh& surface, const GridLines& grid)
        : x_(ray_positions(grid.axis[0], 3.1415e-6)),
          y_(ray_positions(grid.axis[1], 2.7183e-6)),
          crossings_(x_.size() * y_.size()) {
        for (Eigen::Index t = 0; t < surface.triangles.cols(); ++t) add(surface, surface.triangles.col(t));
        for (auto& ray : crossings_) {
            std::sort(ray.begin(), ray.end(), [](const Crossing& a, const Crossing& b) { return a.z < b.z; });
        }
    }

    // Inside intervals of a ray, as alternating begin and end.
    std::vector<double> intervals(std::size_t i, std::size_t j, bool by_winding) const {
        std::vector<double> ends;
        int winding = 0;
        for (const Crossing& c : crossings_[j * x_.size() + i]) {
            // Overlapping parts are one body: only the change between no part and any part bounds an interval.
            const bool was_inside = winding != 0;
            winding = by_winding ? winding + c.turn : 1 - winding;
            if ((winding != 0) != was_inside) ends.push_back(c.z);
        }
        // An interval without end comes from a defect of the surface and is discarded.
        if (ends.size() % 2 == 1) ends.pop_back();
        return ends;
    }

private:
    /// Adds the intersections of one triangle with all rays that pass through it.
    void add(const SurfaceMesh& surface, const Eigen::Vector3i& t) {
        const Eigen::Matrix3Xd& v = surface.vertices;
        const Eigen::Vector3d a = v.col(t[0]), b = v.col(t[1]), c = v.col(t[2]);
        const double twice_area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        if (twice_area == 0.0) return;  // parallel to the rays
        const auto from = [](const std::vector<double>& p, double low) {
            return static_cast<std::size_t>(std::lower_bound(p.begin(), p.end(), low) - p.begin());
        };
        // Ray positions ascend, so the rays within the bounds of the triangle are one range per axis.
        const double x_high = std::max({a[0], b[0], c[0]}), y_high = std::max({a[1], b[1], c[1]});
        for (std::size_t j = from(y_, std::min({a[1], b[1], c[1]})); j < y_.size() && y_[j] <= y_high; ++j) {
            for (std::size_t i = from(x_, std::min({a[0], b[0], c[0]})); i < x_.size() && x_[i] <= x_high; ++i) {
                const bool s0 = left_of(v, t[0], t[1], x_[i], y_[j]), s1 = left_of(v, t[1], t[2], x_[i], y_[j]);
                const bool s2 = left_of(v, t[2], t[0], x_[i], y_[j]);
                // Inside if the ray is on the same side of all edges, for either orientation.
                if (s0 != s1 || s1 != s2) continue;
                // Barycentric weights of the intersection.
                const double wb = ((x_[i] - a[0]) * (c[1] - a[1]) - (y_[j] - a[1]) * (c[0] - a[0])) / twice_area;
                const double wc = ((b[0] - a[0]) * (y_[j] - a[1]) - (b[1] - a[1]) * (x_[i] - a[0])) / twice_area;
                const double z = a[2] + wb * (b[2] - a[2]) + wc * (c[2] - a[2]);
                crossings_[j * x_.size() + i].push_back({z, s0 ? -1 : 1});
            }
        }
    }

    std::vector<double> x_, y_;
    std::vector<std::vector<Crossing>> crossings_;
};

// Adds to each cell of a column the fraction of its height that lies inside.
void add_lengths(const std::vector<double>& intervals, const std::vector<double>& z, std::vector<double>& inside) {
    for (std::size_t e = 0; e + 1 < intervals.size(); e += 2) {
        const double low = intervals[e], high = intervals[e + 1];
        // First cell that the interval meets; the interval may begin below the grid.
        std::size_t k = static_cast<std::size_t>(
            std::max<std::ptrdiff_t>(0, std::upper_bound(z.begin(), z.end(), low) - z.begin() - 1));
        for (; k + 1 < z.size() && z[k] < high; ++k) {
            inside[k] += std::max(0.0, std::min(high, z[k + 1]) - std::max(low, z[k])) / (z[k + 1] - z[k]);
        }
    }
}

}  // namespace

Result<VolumeMesh> voxelize(const SurfaceMesh& surface, const VoxelOptions& options, const Progress& progress) {
    if (!(options.edge > 0.0) || !std::isfinite(options.edge)) return Error{"the edge length must be positive", ""};
    if (surface.triangles.cols() == 0) return Error{"the surface has no triangles", ""};
    if (!surface.vertices.allFinite()) return Error{"a vertex's coordinates are not finite numbers", ""};
    const SurfaceTopology topology = surface_topology(surface);
    if (!topology.closed) {
        return Error{"the surface is not closed: " + std::to_string(topology.open_edges).append(" open edges"), ""};
    }
    const Box box = bounding_box(surface.vertices);
    if (!(box.size().minCoeff() > 0.0)) return Error{"the surface is flat: it encloses no volume", ""};
    const Result<GridLines> limited = options.grid
                                          ? Result<GridLines>(*options.grid)
                                          : limited_grid_lines(box, options.edge, options.planes, options.max_cells);
    if (!limited) return limited.error();
    const GridLines& grid = *limited;
    const Eigen::Vector3i n = grid.cells();
    // All rays are intersected first, with one pass over the triangles.
    const RayField rays(surface, grid);
    VolumeMesh mesh = hex_mesh(grid);
    std::vector<Eigen::Index> solid;
    std::vector<double> inside;
    for (int j = 0; j < n[1]; ++j) {
        if (progress.cancelled()) return Error{"meshing was stopped", ""};
        progress.report({"voxel mesh", double(j), double(n[1]), "rows", ""});
        for (int i = 0; i < n[0]; ++i) {
            inside.assign(static_cast<std::size_t>(n[2]), 0.0);
            for (int ray = 0; ray < voxel_mesh_policy.rays_per_axis * voxel_mesh_policy.rays_per_axis; ++ray) {
                const auto ri = static_cast<std::size_t>(i * voxel_mesh_policy.rays_per_axis +
                                                         ray % voxel_mesh_policy.rays_per_axis);
                const auto rj = static_cast<std::size_t>(j * voxel_mesh_policy.rays_per_axis +
                                                         ray / voxel_mesh_policy.rays_per_axis);
                add_lengths(rays.intervals(ri, rj, topology.oriented), grid.axis[2], inside);
            }
            for (int k = 0; k < n[2]; ++k) {
                // 1e-5: the shift of the rays must not decide about a cell that is cut exactly in half.
                const double fraction = inside[static_cast<std::size_t>(k)] /
                                        (voxel_mesh_policy.rays_per_axis * voxel_mesh_policy.rays_per_axis);
                if (fraction >= options.solid_fraction - 1e-5) solid.push_back((Eigen::Index{k} * n[1] + j) * n[0] + i);
            }
        }
    }
    if (solid.empty()) {
        return Error{"no cell lies at least half inside the body: choose an edge shorter than " +
                         format_number(options.edge * 1e3, 4) + " mm",
                     ""};
    }
    // Cells in the order of the grid, independent of the order of the columns.
    std::sort(solid.begin(), solid.end());
    mesh.cells = mesh.cells(Eigen::all, solid).eval();
    return without_unused_nodes(mesh);
}

}  // namespace myo::mesh
