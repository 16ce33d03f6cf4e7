#pragma once

#include <Eigen/Core>

#include <vector>

#include "mesh/closest_point.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::measurement {

// Observation operator: marker positions from node positions. The marker keeps its place on the material, so that a
// coarse mesh does not displace it, as snapping to the nearest node would.

/// A marker as a function of node positions: interpolated within the nearest boundary face, never moved to a node.
///
/// A marker off the surface moves rigidly with the nearest surface point: position = sum_a w_a x_a + R offset, where R
/// is the rotation of the material there (polar factor of the deformation gradient of the cell behind the face).
struct MarkerBinding {
    std::vector<int> nodes;   // nodes of the cell
    Eigen::VectorXd weights;  // shape functions at the surface point; zero for nodes off the face
    Eigen::Matrix<double, Eigen::Dynamic, 3> gradient;  // dN/dX at the surface point [1/m]
    Eigen::Vector3d offset = Eigen::Vector3d::Zero();   // rest position minus surface point [m]

    /// Distance of the marker from the surface at rest.
    double standoff_m() const { return offset.norm(); }
};

/// Binds a rest position [m, mesh frame] to the nearest point of the boundary. `locator` must belong to `mesh`.
MarkerBinding bind_marker(const mesh::VolumeMesh& mesh, const mesh::BoundaryLocator& locator,
                          const Eigen::Vector3d& rest_m);

/// Marker position [m] for the positions x of the binding's nodes, 3 x nodes [m].
Eigen::Vector3d marker_position(const MarkerBinding& binding, const Eigen::Matrix3Xd& x);

/// Derivative of the marker position along dx, 3 x nodes.
Eigen::Vector3d marker_tangent(const MarkerBinding& binding, const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& dx);

/// Transpose of marker_tangent(): force or adjoint `pull` on the marker, distributed to the binding's nodes, 3 x nodes.
Eigen::Matrix3Xd marker_pull(const MarkerBinding& binding, const Eigen::Matrix3Xd& x, const Eigen::Vector3d& pull);

}  // namespace myo::measurement
