#pragma once

#include <memory>

#include "mesh/volume_mesh.hpp"

namespace myo::mesh {

/// Search structure over a mesh's boundary faces; keeps its own copy of the rest geometry. Cheap to copy, safe to share
/// between threads.
class BoundaryLocator {
public:
    explicit BoundaryLocator(const VolumeMesh& mesh);
    BoundaryLocator(const VolumeMesh& mesh, const BoundaryFaces& faces);

    const BoundaryFaces& faces() const;

    struct Content;
    const Content& content() const { return *content_; }

private:
    std::shared_ptr<const Content> content_;
};

/// A point of the boundary, bound to a face by interpolation.
struct BoundaryPoint {
    int face = -1;                                         // column of BoundaryFaces
    int cell = -1;                                         // the cell behind it
    Eigen::Vector2d parameters = Eigen::Vector2d::Zero();  // (u, v) in the face, see face_shape
    Eigen::VectorXi nodes;                                 // the face's nodes: 4, 3 or 6
    Eigen::VectorXd weights;  // shape functions there; sum 1. Position = sum of weights times node positions
    Eigen::Vector3d point = Eigen::Vector3d::Zero();  // the nearest point [m]
    double distance = 0.0;                            // from the given point [m], never negative
};

/// The boundary point nearest to `point` [m]. Asserts that the mesh has a boundary. On ties the lowest face number.
BoundaryPoint closest_boundary_point(const BoundaryLocator& locator, const Eigen::Vector3d& point);

}  // namespace myo::mesh
