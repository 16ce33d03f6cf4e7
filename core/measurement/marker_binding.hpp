#pragma once

#include <Eigen/Core>

#include <vector>

#include "mesh/closest_point.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::measurement {

/// A marker as a function of node positions: interpolated inside the nearest boundary face, never snapped to a node.
///
/// One that stands off the surface moves rigidly with the nearest surface point: position = sum_a w_a x_a + R offset,
/// where R is the rotation of the material there (polar part of the deformation gradient of the cell behind the face).
struct MarkerBinding {
    std::vector<int> nodes;                             // the cell's nodes
    Eigen::VectorXd weights;                            // shape functions at the surface point; zero off the face
    Eigen::Matrix<double, Eigen::Dynamic, 3> gradient;  // dN/dX there [1/m]
    Eigen::Vector3d offset = Eigen::Vector3d::Zero();   // rest position minus surface point [m]

    double standoff_m() const { return offset.norm(); }
};

/// Binds a rest position [m, mesh frame] to the boundary of the mesh.
MarkerBinding bind_marker(const mesh::VolumeMesh& mesh, const mesh::BoundaryLocator& locator,
                          const Eigen::Vector3d& rest_m);

/// Position [m] for the positions of the binding's nodes (3 x nodes).
Eigen::Vector3d marker_position(const MarkerBinding& binding, const Eigen::Matrix3Xd& x);

/// Its derivative along dx.
Eigen::Vector3d marker_tangent(const MarkerBinding& binding, const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& dx);

/// The transpose of marker_tangent(): what a pull on the marker is on the binding's nodes, 3 x nodes.
Eigen::Matrix3Xd marker_pull(const MarkerBinding& binding, const Eigen::Matrix3Xd& x, const Eigen::Vector3d& pull);

}  // namespace myo::measurement
