#include "fem/material_point.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <limits>

#include "fem/reference_coordinates.hpp"
#include "mesh/cell_traits.hpp"

namespace myo::fem {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// How far reference coordinates lie outside the reference cell, in its own units; at most 0 inside.
double beyond_reference_cell(mesh::CellShape shape, const Vector3d& xi) {
    if (shape == mesh::CellShape::hexahedron) return xi.cwiseAbs().maxCoeff() - 1.0;
    return std::max(-xi.minCoeff(), xi.sum() - 1.0);
}

/// Cell that contains the point, with a margin for rounding on faces; -1: none.
int containing_cell(const mesh::VolumeMesh& mesh, const Vector3d& point) {
    const mesh::CellShape shape = mesh::cell_traits(mesh.type).shape;
    int best = -1;
    double least = 1e-9;
    for (int c = 0; c < static_cast<int>(mesh.cell_count()); ++c) {
        const Matrix3Xd X = mesh.nodes(Eigen::all, mesh.cells.col(c));
        const Vector3d low = X.rowwise().minCoeff(), high = X.rowwise().maxCoeff();
        // Curved faces of quadratic cells can bulge beyond the box of their nodes.
        const double margin = 0.25 * (high - low).maxCoeff();
        if (((low.array() - margin) > point.array()).any() || ((high.array() + margin) < point.array()).any()) continue;
        const double beyond = beyond_reference_cell(shape, reference_coordinates(mesh, c, point));
        if (beyond < least) {
            best = c;
            least = beyond;
        }
    }
    return best;
}

}  // namespace

std::optional<MaterialPoint> material_point_within(const mesh::VolumeMesh& mesh, const mesh::BoundaryLocator& boundary,
                                                   const Vector3d& rest_m, double distance_m) {
    MaterialPoint point;
    Vector3d on_mesh = rest_m;
    point.cell = containing_cell(mesh, rest_m);
    if (point.cell < 0) {
        const mesh::BoundaryPoint nearest = mesh::closest_boundary_point(boundary, rest_m);
        if (nearest.distance > distance_m) return std::nullopt;
        point.cell = nearest.cell;
        on_mesh = nearest.point;
    }
    const auto column = mesh.cells.col(point.cell);
    point.nodes.assign(column.begin(), column.end());
    const Matrix3Xd X = mesh.nodes(Eigen::all, point.nodes);
    mesh::with_cell(mesh.type, [&]<class Shape>(Shape) {
        const Vector3d xi = reference_coordinates<Shape>(X, on_mesh);
        const auto D = Shape::derivatives(xi);
        point.gradient = D * (X * D).inverse();  // dN/dX = dN/dxi (dX/dxi)^-1
        point.weights = Shape::values(xi) + point.gradient * (rest_m - on_mesh);
    });
    return point;
}

MaterialPoint material_point(const mesh::VolumeMesh& mesh, const mesh::BoundaryLocator& boundary,
                             const Vector3d& rest_m) {
    return *material_point_within(mesh, boundary, rest_m, std::numeric_limits<double>::infinity());
}

}  // namespace myo::fem
