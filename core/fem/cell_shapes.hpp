#pragma once

#include <Eigen/Core>

#include <vector>

#include "fem/quadrature.hpp"
#include "fem/shape_functions.hpp"
#include "mesh/volume_mesh.hpp"

// The shape functions of each cell type with their reference cell and quadrature rules. A new cell is a struct in
// shape_functions.hpp, its functions below, and a line in with_shape().

namespace myo::fem {

/// Calls visit(Shape{}) with the shape functions of a cell type.
template <class Visit>
decltype(auto) with_shape(mesh::CellType type, const Visit& visit) {
    switch (type) {
        case mesh::CellType::tet4: return visit(Tet4{});
        case mesh::CellType::tet10: return visit(Tet10{});
        case mesh::CellType::hex8: break;
    }
    return visit(Hex8{});
}

/// Corners of the reference cell, 3 x n.
inline Eigen::Matrix3Xd reference_corners(Hex8) { return Hex8::corners().transpose(); }
inline Eigen::Matrix3Xd reference_corners(Tet4) {
    return (Eigen::Matrix<double, 3, 4>() << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1).finished();
}
inline Eigen::Matrix3Xd reference_corners(Tet10) { return reference_corners(Tet4{}); }

/// Centroid of the reference cell.
inline Eigen::Vector3d reference_centroid(Hex8) { return Eigen::Vector3d::Zero(); }
inline Eigen::Vector3d reference_centroid(Tet4) { return Eigen::Vector3d::Constant(0.25); }
inline Eigen::Vector3d reference_centroid(Tet10) { return reference_centroid(Tet4{}); }

/// Smallest rule for the strains of a straight-sided cell.
inline std::vector<QuadraturePoint> strain_rule(Hex8) { return hex_gauss(2); }
inline std::vector<QuadraturePoint> strain_rule(Tet4) { return tet_centroid(); }
inline std::vector<QuadraturePoint> strain_rule(Tet10) { return tet_degree2(); }

/// Rule for products of two shape functions.
inline std::vector<QuadraturePoint> mass_rule(Hex8) { return hex_gauss(2); }
inline std::vector<QuadraturePoint> mass_rule(Tet4) { return tet_degree2(); }
inline std::vector<QuadraturePoint> mass_rule(Tet10) { return tet_degree5(); }

}  // namespace myo::fem
