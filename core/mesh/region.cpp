#include "mesh/region.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include <Eigen/Dense>

#include "mesh/cell_topology.hpp"
#include "mesh/clipping.hpp"
#include "mesh/face_quadrature.hpp"
#include "mesh/face_shape.hpp"

namespace myo::mesh {
namespace {

using Vector2 = Eigen::Vector2d;
using Vector3 = Eigen::Vector3d;
using Corners = Eigen::Matrix<double, 3, 4>;

// Flat triangle of a face with the face parameters at its corners.
struct Patch {
    std::array<Vector3, 3> x;
    std::array<Vector2, 3> uv;
};

/// Flat triangles that approximate a face: four around the centre of a quadrilateral, four by the mid-side nodes of a
/// quadratic triangle.
std::vector<Patch> flat_patches(const Eigen::Matrix3Xd& X) {
    const int nodes = static_cast<int>(X.cols());
    const auto at = [&](const Vector2& a, const Vector2& b, const Vector2& c) {
        return Patch{{X * face_shape(nodes, a), X * face_shape(nodes, b), X * face_shape(nodes, c)}, {a, b, c}};
    };
    const Vector2 o(0, 0), e1(1, 0), e2(0, 1), one(1, 1), centre(0.5, 0.5), m1(0.5, 0), m2(0, 0.5);
    // A quadrilateral around its centre, a quadratic triangle through its mid-side nodes.
    if (nodes == 3) return {at(o, e1, e2)};
    if (nodes == 4) return {at(o, e1, centre), at(e1, one, centre), at(one, e2, centre), at(e2, o, centre)};
    return {at(o, m1, m2), at(m1, e1, centre), at(m2, centre, e2), at(m1, centre, m2)};
}

// Face parameters of a point on the patch: linear on the patch, then corrected by Newton's method for the bilinear map
// of a quadrilateral.
Vector2 parameters_of(const Patch& patch, const Eigen::Matrix3Xd& X, const Vector3& x) {
    // Coordinates of the point in the patch, by the normal equations.
    const Vector3 e1 = patch.x[1] - patch.x[0], e2 = patch.x[2] - patch.x[0], r = x - patch.x[0];
    Eigen::Matrix2d G;
    G << e1.dot(e1), e1.dot(e2), e1.dot(e2), e2.dot(e2);
    const Vector2 b = G.inverse() * Vector2(e1.dot(r), e2.dot(r));
    Vector2 uv = patch.uv[0] + b[0] * (patch.uv[1] - patch.uv[0]) + b[1] * (patch.uv[2] - patch.uv[0]);
    if (X.cols() != 4) return uv;
    for (int iteration = 0; iteration < 8; ++iteration) {
        const Eigen::Matrix<double, 3, 2> T = X * face_shape_gradient(4, uv);
        const Vector2 step = (T.transpose() * T).ldlt().solve(T.transpose() * (x - X * face_shape(4, uv)));
        if (!step.allFinite()) break;
        uv += step;
        if (step.norm() < 1e-14) break;
    }
    return uv.cwiseMax(0.0).cwiseMin(1.0);
}

/// Integrates the shape functions over the part of a patch inside the box.
void add_patch(const Patch& patch, const Eigen::Matrix3Xd& X, const Eigen::VectorXi& nodes, const Box& box,
               double tolerance, SurfaceIntegral& integral) {
    if ((patch.x[1] - patch.x[0]).cross(patch.x[2] - patch.x[0]).norm() == 0.0) return;
    // The clipped polygon is convex: a fan of triangles from its first vertex.
    const Polygon part = clip_to_box({patch.x[0], patch.x[1], patch.x[2]}, box, tolerance);
    for (std::size_t i = 2; i < part.size(); ++i) {
        const double area = 0.5 * (part[i - 1] - part[0]).cross(part[i] - part[0]).norm();
        if (area == 0.0) continue;
        integral.area += area;
        for (const auto& [uv, weight] :
             face_quadrature(3)) {  // parameters of a bilinear face are not linear in the triangle
            const Vector3 x = (1.0 - uv.sum()) * part[0] + uv[0] * part[i - 1] + uv[1] * part[i];
            const Eigen::VectorXd N = face_shape(static_cast<int>(X.cols()), parameters_of(patch, X, x));
            for (Eigen::Index n = 0; n < nodes.size(); ++n) integral.weight[nodes[n]] += 2.0 * area * weight * N[n];
        }
    }
}

/// True if the points are outside of the box on one side.
bool misses(const Eigen::Matrix3Xd& X, const Box& box, double tolerance) {
    return (X.rowwise().maxCoeff().array() < box.lowest.array() - tolerance).any() ||
           (X.rowwise().minCoeff().array() > box.highest.array() + tolerance).any();
}

// Straight tetrahedra that make up a cell. Their volumes add up to that of the cell.
std::vector<Corners> tetrahedra_of(CellType type, const Eigen::Matrix3Xd& X) {
    std::vector<Corners> parts;
    const auto add = [&](const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d) {
        Corners tet;
        tet << a, b, c, d;
        parts.push_back(tet);
    };
    if (type == CellType::hex8) {
        const Vector3 centre = X.rowwise().mean();
        for (const auto& face : hexahedron_faces) {
            const Vector3 middle = 0.25 * (X.col(face[0]) + X.col(face[1]) + X.col(face[2]) + X.col(face[3]));
            for (std::size_t i = 0; i < 4; ++i) add(X.col(face[i]), X.col(face[(i + 1) % 4]), middle, centre);
        }
    } else if (type == CellType::tet4) {
        add(X.col(0), X.col(1), X.col(2), X.col(3));
    } else {
        // Four corner tetrahedra, and the inner octahedron divided along the diagonal 6-8.
        constexpr std::array<std::array<int, 4>, 8> eight{{{0, 4, 6, 7},
                                                           {4, 1, 5, 8},
                                                           {6, 5, 2, 9},
                                                           {7, 8, 9, 3},
                                                           {4, 6, 7, 8},
                                                           {4, 5, 6, 8},
                                                           {6, 5, 9, 8},
                                                           {6, 7, 8, 9}}};
        for (const auto& t : eight) add(X.col(t[0]), X.col(t[1]), X.col(t[2]), X.col(t[3]));
    }
    return parts;
}

// Volume fraction of an axis-aligned cell inside the box; negative if the cell is not axis-aligned.
double aligned_fraction(const Eigen::Matrix3Xd& X, const Box& box, double tolerance) {
    const Box cell = bounding_box(X);
    for (Eigen::Index i = 0; i < 8; ++i) {
        for (Eigen::Index a = 0; a < 3; ++a) {
            const bool high = hexahedron_corners[static_cast<std::size_t>(i)][static_cast<std::size_t>(a)] == 1;
            if (std::abs(X(a, i) - (high ? cell.highest[a] : cell.lowest[a])) > tolerance) return -1.0;
        }
    }
    // Product of the overlaps along the axes; an empty overlap is negative and counts as none.
    const Eigen::Array3d overlap = cell.highest.array().min(box.highest.array()) -
                                   cell.lowest.array().max(box.lowest.array());
    return (overlap.max(0.0) / cell.size().array()).prod();
}

}  // namespace

double region_tolerance(const VolumeMesh& mesh) {
    return mesh.node_count() == 0 ? 0.0 : 1e-9 * bounding_box(mesh.nodes).size().maxCoeff();
}

std::vector<int> nodes_in_box(const VolumeMesh& mesh, const Box& box, double tolerance) {
    // Nodes on a side of the box must count as inside despite rounding.
    const Box grown{box.lowest.array() - tolerance, box.highest.array() + tolerance};
    std::vector<int> inside;
    for (Eigen::Index i = 0; i < mesh.node_count(); ++i) {
        if (grown.contains(mesh.nodes.col(i))) inside.push_back(static_cast<int>(i));
    }
    return inside;
}

std::vector<int> nodes_in_box(const VolumeMesh& mesh, const Box& box) {
    return nodes_in_box(mesh, box, region_tolerance(mesh));
}

SurfaceIntegral surface_weights(const VolumeMesh& mesh, const BoundaryFaces& faces, const Box& box) {
    const double tolerance = region_tolerance(mesh);
    SurfaceIntegral integral;
    integral.weight = Eigen::VectorXd::Zero(mesh.node_count());
    for (Eigen::Index f = 0; f < faces.count(); ++f) {
        const Eigen::VectorXi nodes = faces.nodes.col(f);
        const Eigen::Matrix3Xd X = mesh.nodes(Eigen::all, nodes);
        // A curved face may extend beyond its nodes; its flat patches do not.
        if (misses(X, box, tolerance)) continue;
        for (const Patch& patch : flat_patches(X)) add_patch(patch, X, nodes, box, tolerance, integral);
    }
    return integral;
}

ClippedVolume cell_in_box(const VolumeMesh& mesh, Eigen::Index cell, const Box& box, double tolerance) {
    ClippedVolume part;
    for (const Corners& tet : tetrahedra_of(mesh.type, mesh.nodes(Eigen::all, mesh.cells.col(cell)))) {
        const ClippedVolume piece = tetrahedron_in_box(tet, box, tolerance);
        part.volume_m3 += piece.volume_m3;
        part.moment_m4 += piece.moment_m4;
        part.second_moment_m5 += piece.second_moment_m5;
    }
    return part;
}

Eigen::VectorXd volume_fractions(const VolumeMesh& mesh, const Box& box) {
    const double tolerance = region_tolerance(mesh);
    Eigen::VectorXd fractions = Eigen::VectorXd::Zero(mesh.cell_count());
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) {
        const Eigen::Matrix3Xd X = mesh.nodes(Eigen::all, mesh.cells.col(c));
        if (misses(X, box, tolerance)) continue;
        // Cells of a grid need no clipping: their fraction is a product of lengths.
        double fraction = mesh.type == CellType::hex8 ? aligned_fraction(X, box, tolerance) : -1.0;
        if (fraction < 0.0) {
            // Relative to the volume of the same tetrahedra, so that a cell in the box has exactly 1.
            double whole = 0.0;
            for (const Corners& tet : tetrahedra_of(mesh.type, X)) {
                Eigen::Matrix3d J;
                for (int i = 0; i < 3; ++i) J.col(i) = tet.col(i + 1) - tet.col(0);
                whole += std::abs(J.determinant()) / 6.0;
            }
            fraction = whole > 0.0 ? cell_in_box(mesh, c, box, tolerance).volume_m3 / whole : 0.0;
        }
        fractions[c] = std::clamp(fraction, 0.0, 1.0);
    }
    return fractions;
}

}  // namespace myo::mesh
