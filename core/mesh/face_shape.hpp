#pragma once

#include <Eigen/Core>

namespace myo::mesh {

/// Shape functions of a boundary face at parameters (u, v).
///
/// 4 nodes: bilinear on [0, 1]^2, node order (0,0) (1,0) (1,1) (0,1). 3 and 6 nodes: linear and quadratic on the
/// triangle u, v >= 0, u + v <= 1, corners (0,0) (1,0) (0,1), then the mid-sides 01, 12, 20.
/// @return  one value per node, sum 1
Eigen::VectorXd face_shape(int nodes, const Eigen::Vector2d& uv);

/// Derivatives of the shape functions of a boundary face.
///
/// @return  nodes x 2, columns d/du and d/dv; X * face_shape_gradient() gives the two tangents of a face
Eigen::MatrixX2d face_shape_gradient(int nodes, const Eigen::Vector2d& uv);

/// Parameters of the point of a face nearest to p, inside the domain of the face.
///
/// Exact on flat faces with straight sides. On curved faces a local minimum by Gauss-Newton steps from the nearest
/// point of the flat approximation, never worse than the nearest point of a quadrilateral's sides.
///
/// @param X  node positions, 3 x (3, 4 or 6) [m]
Eigen::Vector2d closest_face_parameters(const Eigen::Matrix3Xd& X, const Eigen::Vector3d& p);

}  // namespace myo::mesh
