#pragma once

#include <Eigen/Core>

#include <vector>

namespace myo::mesh {

/// Quadrature point of a boundary face.
struct FacePoint {
    Eigen::Vector2d uv;   // parameters of face_shape()
    double weight = 0.0;  // sums to the parameter area: 1 (4 nodes), 1/2 (3 and 6 nodes)
};

/// Quadrature rule of a boundary face.
///
/// @param nodes  4: Gauss-Legendre with 2 points per side, exact to degree 3 in each parameter; 3 or 6: six points,
///               exact to degree 4
/// Source: Dunavant 1985 (triangles).
const std::vector<FacePoint>& face_quadrature(int nodes);

}  // namespace myo::mesh
