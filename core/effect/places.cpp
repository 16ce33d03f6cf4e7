#include "effect/places.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "mesh/closest_point.hpp"
#include "model/held_nodes.hpp"
#include "model/loaded_face.hpp"

namespace myo::effect {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// Farthest-point sampling: `count` of the points, starting with the one farthest from `away`.
std::vector<Vector3d> spread(const Matrix3Xd& points, const Vector3d& away, std::size_t count) {
    std::vector<Vector3d> chosen;
    if (points.cols() == 0) return chosen;
    Eigen::RowVectorXd squared_distance = (points.colwise() - away).colwise().squaredNorm();
    while (chosen.size() < std::min(count, static_cast<std::size_t>(points.cols()))) {
        Index farthest = 0;
        squared_distance.maxCoeff(&farthest);
        const Vector3d next = points.col(farthest);
        // `away` decides on the first point only and is not a point of the set.
        if (chosen.empty()) squared_distance.setConstant(std::numeric_limits<double>::max());
        // Distance of every point to the chosen set; the next point is the one with the largest distance.
        squared_distance = squared_distance.cwiseMin((points.colwise() - next).colwise().squaredNorm());
        chosen.push_back(next);
    }
    return chosen;
}

/// Mean rest position of the supported nodes; the origin if there are none.
Vector3d clamp_centre(const TrialContext& context) {
    const std::vector<int> nodes = model::support_nodes(*context.body);
    if (nodes.empty()) return Vector3d::Zero();
    return Matrix3Xd(context.body->mesh.nodes(Eigen::all, nodes)).rowwise().mean();
}

/// Barycentric coordinates of a point in a triangle, clipped to be non-negative.
Vector3d triangle_shares(const Eigen::Matrix3d& corners, const Vector3d& point) {
    const Vector3d a = corners.col(1) - corners.col(0), b = corners.col(2) - corners.col(0), normal = a.cross(b);
    const double area = normal.squaredNorm();
    // Ratios of signed areas.
    const double v = normal.dot((point - corners.col(0)).cross(b)) / area,
                 w = normal.dot(a.cross(point - corners.col(0))) / area;
    Vector3d shares(1.0 - v - w, v, w);
    shares = shares.cwiseMax(0.0);
    return shares / shares.sum();
}

}  // namespace

SurfacePlace surface_place(const model::Body& body, const Vector3d& near_m) {
    const mesh::BoundaryPoint at = mesh::closest_boundary_point(mesh::BoundaryLocator(body.mesh, body.boundary),
                                                                near_m);
    SurfacePlace place;
    place.cell = at.cell;
    place.point = at.point;
    const auto node = [&](int i) { return Vector3d(body.mesh.nodes.col(at.nodes(i))); };
    // The corner nodes of a boundary face are ordered counter-clockwise seen from outside.
    place.normal = (node(1) - node(0)).cross(node(2) - node(0)).normalized();
    if (at.nodes.size() != 6) {
        place.nodes.assign(at.nodes.begin(), at.nodes.end());
        place.shares = at.weights.cwiseMax(0.0) / at.weights.cwiseMax(0.0).sum();
        return place;
    }
    // The quadratic shape functions of a 6-node face are negative in parts of it, which is inadmissible for masses: use
    // linear ones on the quarter of the face that contains the point.
    constexpr std::array<std::array<int, 3>, 4> quarters = {{{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}}};
    double nearest = std::numeric_limits<double>::max();
    for (const std::array<int, 3>& quarter : quarters) {
        Eigen::Matrix3d corners;
        for (int i = 0; i < 3; ++i) corners.col(i) = node(quarter[static_cast<std::size_t>(i)]);
        const Vector3d shares = triangle_shares(corners, at.point);
        const double distance = (corners * shares - at.point).norm();
        if (distance >= nearest) continue;
        nearest = distance;
        place.shares = shares;
        place.nodes.clear();
        for (const int i : quarter) place.nodes.push_back(at.nodes(i));
    }
    return place;
}

std::vector<Vector3d> spread_surface_points(const TrialContext& context, std::size_t count) {
    const model::Body& body = *context.body;
    const std::vector<int> faces = model::free_faces(body);
    Matrix3Xd centres(3, static_cast<Index>(faces.size()));
    for (std::size_t f = 0; f < faces.size(); ++f)
        centres.col(static_cast<Index>(
            f)) = Matrix3Xd(body.mesh.nodes(Eigen::all, body.boundary.nodes.col(faces[f]))).rowwise().mean();
    return spread(centres, clamp_centre(context), count);
}

std::vector<Vector3d> spread_cells(const TrialContext& context, std::size_t count) {
    return spread(cell_centres(*context.body), clamp_centre(context), count);
}

Matrix3Xd cell_centres(const model::Body& body) {
    Matrix3Xd centres(3, body.cell_count());
    for (Index c = 0; c < centres.cols(); ++c)
        centres.col(c) = Matrix3Xd(body.mesh.nodes(Eigen::all, body.mesh.cells.col(c))).rowwise().mean();
    return centres;
}

ClampAxis clamp_axis(const TrialContext& context) {
    const Matrix3Xd& X = context.body->mesh.nodes;
    const Vector3d lowest = X.rowwise().minCoeff(), highest = X.rowwise().maxCoeff(), size = highest - lowest;
    // The clamp lies at one end: largest offset of its centre relative to the size in that direction.
    const Vector3d off = clamp_centre(context) - 0.5 * (lowest + highest);
    ClampAxis result;
    off.cwiseAbs().cwiseQuotient(size).maxCoeff(&result.axis);
    const int a = result.axis;
    result.sign = off(a) > 0.0 ? -1.0 : 1.0;
    double low = highest(a), high = lowest(a);
    for (Index i = 0; i < X.cols(); ++i)
        if (context.body->clamped[static_cast<std::size_t>(i)]) {
            low = std::min(low, X(a, i));
            high = std::max(high, X(a, i));
        }
    // The last clamped plane is the one towards the free end.
    result.begin_m = result.sign > 0.0 ? high : low;
    result.held_m = std::max(0.0, high - low);
    result.length_m = result.sign > 0.0 ? highest(a) - high : low - lowest(a);
    return result;
}

}  // namespace myo::effect
