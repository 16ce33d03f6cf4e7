#pragma once

#include <Eigen/Core>

#include <vector>

namespace myo::mesh {

/// Points of a boundary face in the parameters of face_shape(); weights sum to the parameters' area: 1 (4 nodes), 1/2
/// (3 and 6).
struct FacePoint {
    Eigen::Vector2d uv;
    double weight = 0.0;
};

/// 4 nodes: Gauss-Legendre, 2 per side, exact to degree 3 in each parameter. 3 and 6 nodes: six points, exact to
/// degree 4. Source: Dunavant 1985.
const std::vector<FacePoint>& face_quadrature(int nodes);

}  // namespace myo::mesh
