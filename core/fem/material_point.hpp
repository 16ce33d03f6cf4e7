#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

#include "mesh/closest_point.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::fem {

/// A point of the material as a function of the node positions of one cell: x(t) = sum of weights times nodes.
struct MaterialPoint {
    int cell = 0;
    std::vector<int> nodes;                             // of the cell
    Eigen::VectorXd weights;                            // shape functions at the point; they sum to 1
    Eigen::Matrix<double, Eigen::Dynamic, 3> gradient;  // dN/dX at the point [1/m]
};

/// Point of the body at a rest position [m]: of the cell that contains it, or, for a position outside the mesh, of the
/// cell behind the nearest point of the boundary, whose shape functions are continued linearly from there: the point
/// moves as if the material went on with the deformation gradient of the boundary.
///
/// @param boundary  of the mesh
MaterialPoint material_point(const mesh::VolumeMesh& mesh, const mesh::BoundaryLocator& boundary,
                             const Eigen::Vector3d& rest_m);

/// material_point() of a position in the mesh or at most `distance_m` off its boundary; empty farther away.
std::optional<MaterialPoint> material_point_within(const mesh::VolumeMesh& mesh, const mesh::BoundaryLocator& boundary,
                                                   const Eigen::Vector3d& rest_m, double distance_m);

}  // namespace myo::fem
