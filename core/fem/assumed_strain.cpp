#include "fem/assumed_strain.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "mesh/cell_hex8.hpp"

namespace myo::fem {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Vector6d = Eigen::Matrix<double, 6, 1>;

/// Hourglass shapes eta zeta, zeta xi, xi eta, xi eta zeta at the corners.
Eigen::Matrix<double, 8, 4> hourglass_shapes() {
    const auto& s = mesh::Hex8::corners();
    Eigen::Matrix<double, 8, 4> h;
    for (int k = 0; k < 3; ++k) h.col(k) = s.col((k + 1) % 3).cwiseProduct(s.col((k + 2) % 3));
    h.col(3) = h.col(0).cwiseProduct(s.col(0));
    return h;
}

/// Symmetric part of a b' as (xx, yy, zz, xy, yz, zx).
Vector6d symmetric_product(const Vector3d& a, const Vector3d& b) {
    const auto of = [&](int i, int j) { return 0.5 * (a(i) * b(j) + a(j) * b(i)); };
    return (Vector6d() << of(0, 0), of(1, 1), of(2, 2), of(0, 1), of(1, 2), of(2, 0)).finished();
}

/// In-plane basis from two edge vectors: dual vectors turn covariant strain components into Cartesian tensors.
AssumedStrainGeometry::Plane plane_of(const Vector3d& g_i, const Vector3d& g_j) {
    Eigen::Matrix<double, 3, 2> g, dual;
    g << g_i, g_j;
    const Eigen::Matrix2d metric = (g.transpose() * g).inverse();  // contravariant
    dual = g * metric;
    AssumedStrainGeometry::Plane plane;
    plane.in_plane << symmetric_product(dual.col(0), dual.col(0)), symmetric_product(dual.col(1), dual.col(1)),
        symmetric_product(dual.col(0), dual.col(1));
    plane.trace << metric(0, 0), metric(1, 1), metric(0, 1);
    const Vector3d n = g_i.cross(g_j).normalized();
    plane.normal = symmetric_product(n, n);
    return plane;
}

AssumedStrainGeometry geometry_of(const Eigen::Matrix<double, 3, 8>& X) {
    static const Eigen::Matrix<double, 8, 4> shapes = hourglass_shapes();
    AssumedStrainGeometry result;
    result.gradient.setZero();
    // G averages dN/dX over the cell with 2 x 2 x 2 Gauss points, exact for the volume of a trilinear hexahedron.
    for (const mesh::QuadraturePoint& point : mesh::hex_gauss(2)) {
        const Eigen::Matrix<double, 8, 3> D = mesh::Hex8::derivatives(point.xi);
        const Matrix3d jacobian = X * D;
        const double weight = point.weight * jacobian.determinant();
        result.gradient += weight * D * jacobian.inverse();
        result.volume += weight;
    }
    result.gradient /= result.volume;
    // Removing G X h makes gamma orthogonal to linear displacement fields (Flanagan-Belytschko projection).
    result.gamma = 0.125 * (shapes - result.gradient * (X * shapes));
    result.edges = X * mesh::Hex8::derivatives(Vector3d::Zero());
    for (std::size_t k = 0; k < 3; ++k) {
        const auto i = static_cast<Eigen::Index>((k + 1) % 3), j = static_cast<Eigen::Index>((k + 2) % 3);
        result.planes[k] = plane_of(result.edges.col(i), result.edges.col(j));
        const Vector3d edge = result.edges.col(static_cast<Eigen::Index>(k));
        result.along[k] = symmetric_product(edge, edge) / std::pow(edge.squaredNorm(), 2);
    }
    return result;
}

}  // namespace

AssumedStrainBlock assumed_strain_block(const mesh::VolumeMesh& mesh, const CellSurroundings& surroundings,
                                        const AssumedStrainPolicy& policy) {
    AssumedStrainBlock block;
    block.cells = mesh.cells;
    block.geometry.reserve(static_cast<std::size_t>(mesh.cell_count()));
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) {
        block.geometry.push_back(geometry_of(mesh.nodes(Eigen::all, mesh.cells.col(c))));
        if (surroundings.empty()) continue;
        for (std::size_t k = 0; k < 3; ++k)
            block.geometry.back().relaxed[k] = policy.relaxed(surroundings[static_cast<std::size_t>(c)][k]);
    }
    return block;
}

}  // namespace myo::fem
