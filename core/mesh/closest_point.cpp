#include "mesh/closest_point.hpp"

#include <cassert>

#include <Eigen/Dense>

#include "mesh/box_tree.hpp"
#include "mesh/face_shape.hpp"

namespace myo::mesh {
namespace {

// A face lies in the convex hull of its nodes. A curved quadratic face may leave it, but stays in the hull of its
// Bezier control points.
Box hull_box(const Eigen::Matrix3Xd& X) {
    if (X.cols() != 6) return bounding_box(X);
    Eigen::Matrix3Xd control = X;
    // Bezier control point of a side from its midpoint: 2 m - (a + b) / 2.
    for (int i = 0; i < 3; ++i) control.col(3 + i) = 2.0 * X.col(3 + i) - 0.5 * (X.col(i) + X.col((i + 1) % 3));
    return bounding_box(control);
}

}  // namespace

/// Shared immutable data of a locator.
struct BoundaryLocator::Content {
    Eigen::Matrix3Xd nodes;
    BoundaryFaces faces;
    BoxTree tree;

    Eigen::Matrix3Xd face(int f) const { return nodes(Eigen::all, faces.nodes.col(f)); }
};

BoundaryLocator::BoundaryLocator(const VolumeMesh& mesh) : BoundaryLocator(mesh, boundary_faces(mesh)) {}

BoundaryLocator::BoundaryLocator(const VolumeMesh& mesh, const BoundaryFaces& faces) {
    std::vector<Box> boxes;
    for (Eigen::Index f = 0; f < faces.count(); ++f) {
        boxes.push_back(hull_box(mesh.nodes(Eigen::all, faces.nodes.col(f))));
    }
    content_ = std::make_shared<const Content>(Content{mesh.nodes, faces, BoxTree(boxes)});
}

const BoundaryFaces& BoundaryLocator::faces() const { return content_->faces; }

BoundaryPoint closest_boundary_point(const BoundaryLocator& locator, const Eigen::Vector3d& point) {
    const auto& content = locator.content();
    assert(content.faces.count() > 0);
    const int nodes = static_cast<int>(content.faces.nodes.rows());
    BoundaryPoint best;
    // The tree bounds the distance by boxes; the exact distance is computed for few faces.
    best.face = content.tree.nearest(point, [&](int f) {
        const Eigen::Matrix3Xd X = content.face(f);
        return (X * face_shape(nodes, closest_face_parameters(X, point)) - point).squaredNorm();
    });
    if (best.face < 0) return best;  // only for a non-finite point
    const Eigen::Matrix3Xd X = content.face(best.face);
    best.cell = content.faces.cell[best.face];
    best.parameters = closest_face_parameters(X, point);
    best.nodes = content.faces.nodes.col(best.face);
    best.weights = face_shape(nodes, best.parameters);
    best.point = X * best.weights;
    best.distance = (best.point - point).norm();
    return best;
}

}  // namespace myo::mesh
