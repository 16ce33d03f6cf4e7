#include "experiment/body_queries.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

#include "mesh/face_shape.hpp"
#include "mesh/winding_number.hpp"

namespace myo::experiment {
namespace {

// Corners of a triangle as columns [m].
Eigen::Matrix3d corners(const mesh::SurfaceMesh& surface, Eigen::Index triangle) {
    Eigen::Matrix3d X;
    for (int i = 0; i < 3; ++i) X.col(i) = surface.vertices.col(surface.triangles(i, triangle));
    return X;
}

}  // namespace

// STL stores 32-bit floats: a face meant to lie at 0.1 m can be off by 6e-9 m. The tolerance is relative to the
// extent.
BodyQueries::BodyQueries(const mesh::SurfaceMesh& body)
    : body_(body), tolerance_(1e-7 * mesh::bounding_box(body.vertices).size().maxCoeff()) {}

// If no triangle intersects the box, the box lies entirely inside or entirely outside the body; the generalised
// winding number of its centre decides.
bool BodyQueries::holds_material(const Box& box) const {
    for (Eigen::Index t = 0; t < body_.triangles.cols(); ++t)
        if (!part_in(box, t).empty()) return true;
    return in_material(0.5 * (box.lowest + box.highest));
}

// The box is shrunk by twice the tolerance on all sides, as clipping keeps what lies within the tolerance of a side: a
// box that only touches the surface from outside has no common volume with the body.
bool BodyQueries::holds_volume(Box box) const {
    box.lowest.array() += 2.0 * tolerance_;
    box.highest.array() -= 2.0 * tolerance_;
    return (box.size().array() > 0.0).all() && holds_material(box);
}

// The bounding box suffices: an axis-aligned box contains the body exactly if it contains all its vertices.
bool BodyQueries::lies_in(const Box& box) const {
    const Box bounds = mesh::bounding_box(body_.vertices);
    return (bounds.lowest.array() >= box.lowest.array() - tolerance_).all() &&
           (bounds.highest.array() <= box.highest.array() + tolerance_).all();
}

// Area of the surface clipped to the box, by a triangle fan per clipped polygon. The threshold rejects the sliver
// of area that the tolerance alone can produce along an edge of the body.
bool BodyQueries::holds_surface(const Box& box) const {
    double area = 0.0;
    for (Eigen::Index t = 0; t < body_.triangles.cols(); ++t) {
        const mesh::Polygon part = part_in(box, t);
        for (std::size_t i = 2; i < part.size(); ++i)
            area += 0.5 * (part[i - 1] - part[0]).cross(part[i] - part[0]).norm();
    }
    return area > 4.0 * tolerance_ * mesh::bounding_box(body_.vertices).size().maxCoeff();
}

// The winding number is 1 in the material and 0 outside it or in a cavity; a half separates them whatever the rounding.
bool BodyQueries::in_material(const Eigen::Vector3d& point) const { return mesh::winding_number(body_, point) > 0.5; }

// Exhaustive over the triangles: it runs once per marker, so a search tree would not pay.
double BodyQueries::distance_to_surface(const Eigen::Vector3d& point) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (Eigen::Index t = 0; t < body_.triangles.cols(); ++t) {
        const Eigen::Matrix3Xd X = corners(body_, t);
        nearest = std::min(nearest, (X * mesh::face_shape(3, mesh::closest_face_parameters(X, point)) - point).norm());
    }
    return nearest;
}

mesh::Polygon BodyQueries::part_in(const Box& box, Eigen::Index triangle) const {
    const Eigen::Matrix3d X = corners(body_, triangle);
    return mesh::clip_to_box({X.col(0), X.col(1), X.col(2)}, box, tolerance_);
}

}  // namespace myo::experiment
