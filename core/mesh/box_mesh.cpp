#include "mesh/box_mesh.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <Eigen/Dense>

#include "base/text.hpp"
#include "mesh/cell_topology.hpp"

namespace myo::mesh {
namespace {

/// Number of equal cells in an interval. The upper bound prevents an integer overflow for a tiny edge.
int cell_count(double extent, double edge) { return static_cast<int>(std::clamp(std::round(extent / edge), 1.0, 1e9)); }

// End points and planes of one axis, sorted, without planes closer than 1e-6 of the extent to one another or to the
// ends.
std::vector<double> axis_stops(double lowest, double highest, std::vector<double> planes) {
    const double same = 1e-6 * (highest - lowest);
    std::sort(planes.begin(), planes.end());
    std::vector<double> stops{lowest};
    for (const double plane : planes) {
        // Sorted order guarantees that comparison with the last accepted plane is sufficient.
        if (plane > stops.back() + same && plane < highest - same) stops.push_back(plane);
    }
    stops.push_back(highest);
    return stops;
}

/// Number of cells of interval i, with the edge length at its midpoint.
int cells_between(const std::vector<double>& stops, std::size_t i, int axis, const EdgeAt& edge) {
    return cell_count(stops[i + 1] - stops[i], edge(axis, 0.5 * (stops[i] + stops[i + 1])));
}

/// Coordinates of all grid planes of one axis.
std::vector<double> axis_lines(const std::vector<double>& stops, int axis, const EdgeAt& edge) {
    std::vector<double> lines{stops.front()};
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
        // The end of an interval is its plane itself: interpolation would round it.
        const int n = cells_between(stops, i, axis, edge);
        for (int k = 1; k < n; ++k) lines.push_back(stops[i] + (stops[i + 1] - stops[i]) * k / n);
        lines.push_back(stops[i + 1]);
    }
    return lines;
}

/// Number of cells of the grid, computed without building it.
double expected_cells(const Box& box, const EdgeAt& edge, const GridPlanes& planes) {
    double cells = 1.0;
    for (std::size_t a = 0; a < 3; ++a) {
        const auto i = static_cast<Eigen::Index>(a);
        const std::vector<double> stops = axis_stops(box.lowest[i], box.highest[i], planes[a]);
        double along = 0.0;
        for (std::size_t s = 0; s + 1 < stops.size(); ++s) along += cells_between(stops, s, static_cast<int>(a), edge);
        cells *= along;
    }
    return cells;
}

/// Error message of limited_grid_lines().
Error too_many_cells(double edge, double cells, double max_cells) {
    return {"an edge of " + format_number(edge * 1e3, 4) + " mm needs a grid of " + format_number(cells, 3) +
                " cells, over the limit of " + format_number(max_cells, 3) + ": choose a longer edge",
            ""};
}

/// Grid with equal cells per axis.
GridLines equal_grid(const Box& box, const Eigen::Vector3i& cells) {
    assert((cells.array() > 0).all());
    GridLines grid;
    for (int a = 0; a < 3; ++a) {
        auto& lines = grid.axis[static_cast<std::size_t>(a)];
        for (int k = 0; k < cells[a]; ++k) lines.push_back(box.lowest[a] + box.size()[a] * k / cells[a]);
        lines.push_back(box.highest[a]);
    }
    return grid;
}

/// Axes along which a cell of the grid has an odd index.
std::array<bool, 3> odd_axes(Eigen::Index cell, const Eigen::Vector3i& cells) {
    return {cell % cells[0] % 2 == 1, cell / cells[0] % cells[1] % 2 == 1, cell / cells[0] / cells[1] % 2 == 1};
}

/// Corner of a hexahedron mirrored along the given axes.
int mirrored_corner(int corner, const std::array<bool, 3>& axes) {
    std::array<int, 3> at = hexahedron_corners[static_cast<std::size_t>(corner)];
    for (std::size_t a = 0; a < 3; ++a)
        if (axes[a]) at[a] = 1 - at[a];
    return static_cast<int>(std::find(hexahedron_corners.begin(), hexahedron_corners.end(), at) -
                            hexahedron_corners.begin());
}

}  // namespace

Eigen::Vector3i box_cells(const Box& box, double edge) {
    assert(edge > 0.0);
    const Eigen::Vector3d size = box.size();
    return {cell_count(size[0], edge), cell_count(size[1], edge), cell_count(size[2], edge)};
}

GridLines grid_lines(const Box& box, double edge, const GridPlanes& planes) {
    assert(edge > 0.0);
    return grid_lines(
        box, [=](int, double) { return edge; }, planes);
}

GridLines grid_lines(const Box& box, const EdgeAt& edge, const GridPlanes& planes) {
    GridLines grid;
    for (std::size_t a = 0; a < 3; ++a) {
        const auto i = static_cast<Eigen::Index>(a);
        grid.axis[a] = axis_lines(axis_stops(box.lowest[i], box.highest[i], planes[a]), static_cast<int>(a), edge);
    }
    return grid;
}

Result<GridLines> limited_grid_lines(const Box& box, double edge, const GridPlanes& planes, double max_cells) {
    return limited_grid_lines(
        box, [=](int, double) { return edge; }, planes, max_cells);
}

Result<GridLines> limited_grid_lines(const Box& box, const EdgeAt& edge, const GridPlanes& planes, double max_cells) {
    // A product of doubles: it cannot overflow where the number of cells as an integer would.
    const double cells = expected_cells(box, edge, planes);
    if (cells > max_cells) return too_many_cells(edge(0, 0.5 * (box.lowest[0] + box.highest[0])), cells, max_cells);
    return grid_lines(box, edge, planes);
}

Result<GridLines> whole_cube_lines(const Box& box, double edge, const std::array<bool, 3>& from_highest,
                                   double max_cells) {
    assert(edge > 0.0);
    // The allowance keeps the last cube if the edge divides the box exactly up to rounding.
    const Eigen::Array3d counts = (box.size().array() / edge * (1.0 + 1e-9)).floor();
    if (counts.minCoeff() < 1.0)
        return Error{
            "no whole cube of " + format_number(edge * 1e3, 4) + " mm fits into the body: choose a shorter edge", ""};
    if (counts.prod() > max_cells) return too_many_cells(edge, counts.prod(), max_cells);
    GridLines grid;
    for (std::size_t a = 0; a < 3; ++a) {
        const auto i = static_cast<Eigen::Index>(a);
        const int n = static_cast<int>(counts(i));
        const double first = from_highest[a] ? box.highest(i) - n * edge : box.lowest(i);
        for (int k = 0; k <= n; ++k) grid.axis[a].push_back(first + k * edge);
        // The last plane is set exactly, since first + n * edge carries rounding.
        if (from_highest[a]) grid.axis[a].back() = box.highest(i);
    }
    return grid;
}

VolumeMesh hex_mesh(const GridLines& grid) {
    const Eigen::Vector3i n = grid.cells();
    assert((n.array() > 0).all());
    // Node numbers with x fastest, as the loops below create them.
    const auto node = [&](int i, int j, int k) { return (k * (n[1] + 1) + j) * (n[0] + 1) + i; };

    VolumeMesh mesh;
    mesh.type = CellType::hex8;
    mesh.nodes.resize(3, Eigen::Index{n[0] + 1} * (n[1] + 1) * (n[2] + 1));
    Eigen::Index column = 0;
    for (const double z : grid.axis[2]) {
        for (const double y : grid.axis[1]) {
            for (const double x : grid.axis[0]) mesh.nodes.col(column++) << x, y, z;
        }
    }
    mesh.cells.resize(8, Eigen::Index{n[0]} * n[1] * n[2]);
    column = 0;
    for (int k = 0; k < n[2]; ++k) {
        for (int j = 0; j < n[1]; ++j) {
            for (int i = 0; i < n[0]; ++i, ++column) {
                for (Eigen::Index c = 0; c < 8; ++c) {
                    const auto& corner = hexahedron_corners[static_cast<std::size_t>(c)];
                    mesh.cells(c, column) = node(i + corner[0], j + corner[1], k + corner[2]);
                }
            }
        }
    }
    return mesh;
}

VolumeMesh box_hex_mesh(const Box& box, const Eigen::Vector3i& cells) { return hex_mesh(equal_grid(box, cells)); }

VolumeMesh tet_box_mesh(const Box& box, const Eigen::Vector3i& cells, CellType type, Diagonals diagonals) {
    assert(type != CellType::hex8);
    // The tetrahedra share the nodes of the hexahedral grid.
    const VolumeMesh hexes = box_hex_mesh(box, cells);
    // Each tetrahedron follows a path from corner 0 to corner 6 along the three axes, one per order of the axes (Kuhn).
    // Even permutations have positive volume.
    constexpr std::array<std::array<int, 4>, 6> paths{
        {{0, 1, 2, 6}, {0, 3, 7, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}, {0, 2, 3, 6}, {0, 7, 4, 6}}};
    VolumeMesh mesh;
    mesh.type = CellType::tet4;
    mesh.nodes = hexes.nodes;
    mesh.cells.resize(4, 6 * hexes.cell_count());
    for (Eigen::Index c = 0; c < hexes.cell_count(); ++c) {
        // Mirroring along an odd number of axes reverses the orientation; swapping two corners restores it.
        const std::array<bool, 3> turned = diagonals == Diagonals::mirrored ? odd_axes(c, cells)
                                                                            : std::array<bool, 3>{};
        const bool inside_out = (turned[0] + turned[1] + turned[2]) % 2 == 1;
        for (Eigen::Index p = 0; p < 6; ++p) {
            for (Eigen::Index i = 0; i < 4; ++i) {
                const int corner = paths[static_cast<std::size_t>(p)][static_cast<std::size_t>(i)];
                mesh.cells(i, 6 * c + p) = hexes.cells(mirrored_corner(corner, turned), c);
            }
            if (inside_out) std::swap(mesh.cells(2, 6 * c + p), mesh.cells(3, 6 * c + p));
        }
    }
    return type == CellType::tet10 ? to_tet10(mesh) : mesh;
}

VolumeMesh to_tet10(const VolumeMesh& mesh) {
    assert(mesh.type != CellType::hex8);
    if (mesh.type == CellType::tet10) return mesh;

    // Mid-side nodes are numbered by the sorted list of edges, found again by binary search.
    using Edge = std::pair<int, int>;
    // Lower node first, so that an edge has one key in all cells.
    const auto edge_of = [&](Eigen::Index cell, std::size_t e) {
        const int a = mesh.cells(tetrahedron_edges[e][0], cell);
        const int b = mesh.cells(tetrahedron_edges[e][1], cell);
        return Edge(std::min(a, b), std::max(a, b));
    };
    std::vector<Edge> edges;
    edges.reserve(static_cast<std::size_t>(mesh.cell_count()) * 6);
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) {
        for (std::size_t e = 0; e < 6; ++e) edges.push_back(edge_of(c, e));
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());

    VolumeMesh quadratic;
    quadratic.type = CellType::tet10;
    quadratic.regions = mesh.regions;
    quadratic.nodes.resize(3, mesh.node_count() + static_cast<Eigen::Index>(edges.size()));
    // Corners keep their numbers, so that node sets of the linear mesh remain valid.
    quadratic.nodes.leftCols(mesh.node_count()) = mesh.nodes;
    for (std::size_t e = 0; e < edges.size(); ++e) {
        quadratic.nodes.col(mesh.node_count() + static_cast<Eigen::Index>(e)) = 0.5 * (mesh.nodes.col(edges[e].first) +
                                                                                       mesh.nodes.col(edges[e].second));
    }
    quadratic.cells.resize(10, mesh.cell_count());
    quadratic.cells.topRows(4) = mesh.cells;
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) {
        for (std::size_t e = 0; e < 6; ++e) {
            const auto found = std::lower_bound(edges.begin(), edges.end(), edge_of(c, e)) - edges.begin();
            quadratic.cells(4 + static_cast<Eigen::Index>(e), c) = static_cast<int>(mesh.node_count() + found);
        }
    }
    return quadratic;
}

std::optional<Box> is_box(const SurfaceMesh& surface, double tolerance) {
    // Fewer than the corners and half faces of a box.
    if (surface.vertices.cols() < 8 || surface.triangles.cols() < 12) return std::nullopt;
    const Box box = bounding_box(surface.vertices);
    // Every vertex must lie on at least one face of the bounding box.
    const double slack = tolerance * box.size().maxCoeff();
    for (Eigen::Index v = 0; v < surface.vertices.cols(); ++v) {
        const Eigen::Array3d x = surface.vertices.col(v).array();
        if (((x - box.lowest.array()).min(box.highest.array() - x)).minCoeff() > slack) return std::nullopt;
    }
    // All vertices may lie on the box while a corner is cut off. Comparing the volumes excludes this.
    const double full = box.size().prod();
    if (!(full > 0.0) || std::abs(enclosed_volume(surface) - full) > 6.0 * tolerance * full) return std::nullopt;
    return box;
}

}  // namespace myo::mesh
