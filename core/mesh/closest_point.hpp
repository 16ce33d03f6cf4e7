#pragma once

#include <memory>

#include "mesh/volume_mesh.hpp"

namespace myo::mesh {

/// Search structure over the boundary faces of a mesh, with a copy of the rest geometry. Copies share the data; safe to
/// share between threads.
class BoundaryLocator {
public:
    /// Locator over the complete boundary of a mesh.
    explicit BoundaryLocator(const VolumeMesh& mesh);
    /// Locator over some boundary faces of a mesh.
    BoundaryLocator(const VolumeMesh& mesh, const BoundaryFaces& faces);

    /// Faces that are searched.
    const BoundaryFaces& faces() const;

    struct Content;
    const Content& content() const { return *content_; }

private:
    std::shared_ptr<const Content> content_;
};

/// Point on the boundary, given by interpolation in a face.
struct BoundaryPoint {
    int face = -1;                                         // column of BoundaryFaces
    int cell = -1;                                         // cell behind the face
    Eigen::Vector2d parameters = Eigen::Vector2d::Zero();  // (u, v) in the face, see face_shape()
    Eigen::VectorXi nodes;                                 // nodes of the face: 4, 3 or 6
    Eigen::VectorXd weights;  // shape functions at the point, sum 1; position = sum of weights times node positions
    Eigen::Vector3d point = Eigen::Vector3d::Zero();  // nearest point [m]
    double distance = 0.0;                            // from the query point [m], >= 0
};

/// Boundary point nearest to a given point.
///
/// Asserts that the locator has faces.
///
/// @param point  [m], mesh frame
/// @return       the lowest face number on ties; face -1 if the point is not finite
BoundaryPoint closest_boundary_point(const BoundaryLocator& locator, const Eigen::Vector3d& point);

}  // namespace myo::mesh
