#include "mesh/quality.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Dense>

#include "base/text.hpp"
#include "mesh/box_mesh.hpp"
#include "mesh/cell_topology.hpp"
#include "mesh/voxel_mesh.hpp"

namespace myo::mesh {
namespace {

using Vector3 = Eigen::Vector3d;

struct QualityPolicy {
    /// Relative error of mass and, in thin parts, of stiffness.
    double max_volume_error = 0.01;
    /// Shape measure below which a cell counts as almost flat: a tetrahedron whose height is a hundredth of its edges
    /// has 0.05 to 0.08, TetGen's worst near faces of clamps 0.02. Such a cell limits the step and is far too stiff.
    double flat_shape = 0.02;
};
constexpr QualityPolicy quality_policy;

// Neighbours of each corner of a hexahedron along its three edges, right-handed.
constexpr std::array<std::array<int, 3>, 8> hexahedron_neighbours{
    {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}}};

/// det(a, b, c) divided by the edge lengths; 0 for a degenerate corner.
double scaled_jacobian(const Vector3& a, const Vector3& b, const Vector3& c) {
    const double lengths = a.norm() * b.norm() * c.norm();
    return lengths > 0.0 ? a.dot(b.cross(c)) / lengths : 0.0;
}

/// Least scaled Jacobian over the corners and the centre of a hexahedron, see cell_shapes().
double hexahedron_shape(const Eigen::Matrix<double, 3, 8>& X) {
    const auto mean = [&](int a, int b, int c, int d) -> Vector3 {
        return 0.25 * (X.col(a) + X.col(b) + X.col(c) + X.col(d));
    };
    // The centre uses the vectors between midpoints of opposite faces.
    double least = scaled_jacobian(mean(1, 2, 6, 5) - mean(0, 4, 7, 3), mean(3, 7, 6, 2) - mean(0, 1, 5, 4),
                                   mean(4, 5, 6, 7) - mean(0, 3, 2, 1));
    for (int i = 0; i < 8; ++i) {
        const auto& [a, b, c] = hexahedron_neighbours[static_cast<std::size_t>(i)];
        least = std::min(least, scaled_jacobian(X.col(a) - X.col(i), X.col(b) - X.col(i), X.col(c) - X.col(i)));
    }
    return least;
}

/// Mean ratio of a tetrahedron, with the sign of its volume.
double tetrahedron_shape(const Eigen::Matrix<double, 3, 4>& X) {
    Eigen::Matrix3d J;
    for (int i = 0; i < 3; ++i) J.col(i) = X.col(i + 1) - X.col(0);
    const double volume = J.determinant() / 6.0;
    double squares = 0.0;
    for (const auto& [a, b] : tetrahedron_edges) squares += (X.col(a) - X.col(b)).squaredNorm();
    if (!(squares > 0.0)) return 0.0;
    const double shape = 12.0 * std::pow(3.0 * std::abs(volume), 2.0 / 3.0) / squares;
    return volume < 0.0 ? -shape : shape;
}

// Interior dihedral angles of a cell [degrees]; extends the range.
void widen_dihedral_range(const VolumeMesh& mesh, Eigen::Index cell, double& least, double& largest) {
    const auto point = [&](int local) -> Vector3 { return mesh.nodes.col(mesh.cells(local, cell)); };
    const auto angle = [&](const Vector3& from, const Vector3& to, const Vector3& p, const Vector3& q) {
        // Angle between the directions to p and q perpendicular to the common edge.
        const Vector3 axis = (to - from).normalized();
        const Vector3 a = (p - from) - axis * axis.dot(p - from), b = (q - from) - axis * axis.dot(q - from);
        const double degrees = std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / std::numbers::pi;
        least = std::min(least, degrees);
        largest = std::max(largest, degrees);
    };
    if (mesh.type == CellType::hex8) {
        for (int i = 0; i < 8; ++i) {
            const auto& n = hexahedron_neighbours[static_cast<std::size_t>(i)];
            for (std::size_t k = 0; k < 3; ++k)
                angle(point(i), point(n[k]), point(n[(k + 1) % 3]), point(n[(k + 2) % 3]));
        }
        return;
    }
    for (const auto& [a, b] : tetrahedron_edges) {
        // The two corners that are not on the edge: their numbers add up to 6 - a - b.
        const int c = (a != 0 && b != 0) ? 0 : (a != 1 && b != 1) ? 1 : 2;
        angle(point(a), point(b), point(c), point(6 - a - b - c));
    }
}

/// Warning on almost flat cells: how many, and where the worst is; empty if there are none.
std::string flat_cells(const VolumeMesh& mesh, const Eigen::VectorXd& shapes, const QualityReport& report) {
    const Eigen::Index flat = (shapes.array() > 0.0 && shapes.array() < quality_policy.flat_shape).count();
    if (flat == 0) return {};
    Eigen::Index worst = 0;
    // Inverted cells have a warning of their own; 2 exceeds every shape.
    (shapes.array() > 0.0).select(shapes, 2.0).minCoeff(&worst);
    const Eigen::Vector3d middle = 1e3 * mesh.nodes(Eigen::all, mesh.cells.col(worst)).rowwise().mean();
    return std::to_string(flat) + " of " + std::to_string(mesh.cell_count()) +
           (flat == 1 ? " cells is" : " cells are") + " almost flat (" + report.measure + " below " +
           format_number(quality_policy.flat_shape) + "), the worst with " + format_number(shapes[worst], 2) +
           ": cell " + std::to_string(worst) + " at (" + format_number(middle[0], 3) + ", " +
           format_number(middle[1], 3) + ", " + format_number(middle[2], 3) +
           ") mm; flat cells are far too stiff: mesh the body again";
}

}  // namespace

double mean_edge_length(const VolumeMesh& mesh) {
    std::vector<std::pair<int, int>> edges;
    const auto add = [&](const auto& table) {
        edges.reserve(static_cast<std::size_t>(mesh.cell_count()) * table.size());
        for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) {
            for (const auto& e : table) edges.push_back(std::minmax(mesh.cells(e[0], c), mesh.cells(e[1], c)));
        }
    };
    if (mesh.type == CellType::hex8)
        add(hexahedron_edges);
    else
        add(tetrahedron_edges);
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    double sum = 0.0;
    for (const auto& [a, b] : edges) sum += (mesh.nodes.col(a) - mesh.nodes.col(b)).norm();
    return edges.empty() ? 0.0 : sum / static_cast<double>(edges.size());
}

Eigen::VectorXd cell_shapes(const VolumeMesh& mesh) {
    Eigen::VectorXd shapes(mesh.cell_count());
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) {
        const Eigen::Matrix3Xd X = mesh.nodes(Eigen::all, mesh.cells.col(c));
        shapes[c] = mesh.type == CellType::hex8 ? hexahedron_shape(X) : tetrahedron_shape(X.leftCols<4>());
    }
    return shapes;
}

QualityReport mesh_quality(const VolumeMesh& mesh, const SurfaceMesh* surface) {
    QualityReport report;
    report.measure = mesh.type == CellType::hex8 ? "scaled Jacobian" : "mean ratio";
    report.nodes = mesh.node_count();
    report.cells = mesh.cell_count();
    report.dofs = 3 * report.nodes;
    if (mesh.cell_count() == 0) {
        report.messages = {"the mesh has no cells"};
        return report;
    }
    const Eigen::VectorXd shapes = cell_shapes(mesh);
    report.least = shapes.minCoeff(&report.worst_cell);
    report.mean = shapes.mean();
    report.min_dihedral_deg = 180.0;
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) {
        // 1e-9 keeps a perfect cell in the last bin under rounding.
        const int bin = std::clamp(static_cast<int>(std::floor(10.0 * shapes[c] + 1e-9)), 0, 9);
        ++report.histogram[static_cast<std::size_t>(bin)];
        widen_dihedral_range(mesh, c, report.min_dihedral_deg, report.largest_dihedral_deg);
    }
    report.mean_edge = mean_edge_length(mesh);
    report.volume = cell_volumes(mesh).sum();
    if (surface != nullptr) {
        // The reference is the surface before meshing, so the error includes staircases and straight edges.
        const double true_volume = std::abs(enclosed_volume(*surface));
        if (true_volume > 0.0) report.volume_error = (report.volume - true_volume) / true_volume;
    }
    const Connectivity held = connectivity(mesh);
    report.components = held.components;
    report.weak_edges = held.weak_edges;
    report.weak_nodes = held.weak_nodes;

    if (held.components > 1) {
        report.messages.push_back("the mesh falls apart into " + std::to_string(held.components).append(" pieces"));
    }
    if (held.weak_edges + held.weak_nodes > 0) {
        report.messages.push_back("cells hang together by an edge or a corner only at " +
                                  std::to_string(held.weak_nodes).append(held.weak_nodes == 1 ? " node" : " nodes"));
    }
    if (report.least <= 0.0) {
        report.messages.push_back("cell " + std::to_string(report.worst_cell).append(" is turned inside out"));
    }
    if (std::string flat = flat_cells(mesh, shapes, report); !flat.empty()) report.messages.push_back(std::move(flat));
    if (report.volume_error && std::abs(*report.volume_error) > quality_policy.max_volume_error) {
        report.messages.push_back("the mesh's volume differs from the surface's by " +
                                  format_number(100.0 * *report.volume_error, 3) +
                                  " %, more than 1 %: choose shorter edges or tetrahedra");
    }
    return report;
}

CountEstimate estimate_counts(const SurfaceMesh& surface, CellType type, double edge) {
    CountEstimate estimate;
    if (!(edge > 0.0) || surface.vertices.cols() == 0) return estimate;
    const Box box = bounding_box(surface.vertices);
    double area = 0.0;
    for (Eigen::Index t = 0; t < surface.triangles.cols(); ++t) {
        const Vector3 a = surface.vertices.col(surface.triangles(0, t));
        area += 0.5 * (Vector3(surface.vertices.col(surface.triangles(1, t))) - a)
                          .cross(Vector3(surface.vertices.col(surface.triangles(2, t))) - a)
                          .norm();
    }
    // Independent of the orientation of the surface.
    const double volume = std::abs(enclosed_volume(surface));
    if (type == CellType::hex8) {
        const Eigen::Array3d n = box_cells(box, edge).cast<double>().array();
        const Eigen::Array3d d = box.size().array() / n;
        const double cell = d.prod();
        estimate.exact = is_box(surface).has_value();
        estimate.cells = estimate.exact ? n.prod() : volume / cell;
        // Nodes exceed cells by half a layer along the surface. A staircase exposes more faces than the smooth surface:
        // 1.5 times on average over all directions, 1 for a box aligned with the grid; 1.2 lies between the two.
        const double side = std::cbrt(cell * cell);
        estimate.nodes = estimate.exact ? (n + 1.0).prod() : estimate.cells + 0.5 * 1.2 * area / side + 1.0;
    } else {
        // Measured with TetGen: cells times edge^3 is 10 times the volume (8.8 to 10.7).
        estimate.cells = std::max(10.0 * volume / (edge * edge * edge), 1.0);
        // Euler's formula for a ball: with F boundary triangles, nodes = edges - cells - F/2 + 1. TetGen's interior
        // nodes have about 6 cells each; boundary triangles are nearly equilateral.
        const double faces = std::max(area / (0.433 * edge * edge), static_cast<double>(surface.triangles.cols()));
        const double corners = estimate.cells / 6.0 + faces / 3.0 + 2.0;
        const double edges = estimate.cells + corners + 0.5 * faces - 1.0;
        estimate.nodes = type == CellType::tet4 ? corners : corners + edges;
    }
    estimate.dofs = 3.0 * estimate.nodes;
    return estimate;
}

}  // namespace myo::mesh
