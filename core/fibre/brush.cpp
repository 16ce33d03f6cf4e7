#include "fibre/brush.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "fibre/cell_parts.hpp"

namespace myo::fibre {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

struct BrushPolicy {
    /// Cells whose centre is up to this many edges above the surface still count as surface cells: a voxel surface
    /// differs from the body's.
    double above_surface = 0.5;
};
constexpr BrushPolicy brush_policy;

/// Reflection of a vector.
Vector3d mirrored(const Vector3d& v, const Vector3d& normal) { return v - 2.0 * v.dot(normal) * normal; }

}  // namespace

double Brush::weight(double distance_m) const {
    if (distance_m > radius_m) return 0.0;
    // Smoothstep 3 s^2 - 2 s^3: continuous slope at both ends of the falloff.
    const double soft = falloff * radius_m, inside = radius_m - distance_m;
    if (inside >= soft) return strength;
    const double s = inside / soft;
    return strength * s * s * (3.0 - 2.0 * s);
}

CellPlaces cell_places(const mesh::VolumeMesh& mesh, const Eigen::Matrix2Xi& neighbours) {
    CellPlaces places;
    places.centre_m.resize(3, mesh.cell_count());
    const CellPart whole = whole_cell(mesh.type);
    for (int c = 0; c < static_cast<int>(mesh.cell_count()); ++c)
        places.centre_m.col(c) = place_of(mesh, c, whole).centre_m;
    for (const auto pair : neighbours.colwise())
        places.edge_m += (places.centre_m.col(pair(0)) - places.centre_m.col(pair(1))).norm();
    if (neighbours.cols() > 0) places.edge_m /= static_cast<double>(neighbours.cols());
    return places;
}

Stroke::Stroke(const CellPlaces& places, const Brush& brush)
    : places_(places),
      brush_(brush),
      weights_(Eigen::VectorXd::Zero(places.centre_m.cols())),
      dyads_(static_cast<std::size_t>(places.centre_m.cols()), Matrix3d::Zero()) {
    assert(brush.radius_m > 0.0 && brush.falloff >= 0.0 && brush.falloff <= 1.0);
}

void Stroke::add(const Vector3d& position_m, const Vector3d& outward) {
    const Point to{position_m, outward}, from = points_.empty() ? to : points_.back();
    points_.push_back(to);
    press(from, to);
    if (!brush_.mirror) return;
    const MirrorPlane& mirror = *brush_.mirror;
    // Reflection of position and normal.
    const auto across = [&](const Point& p) {
        return Point{mirror.point_m + mirrored(p.position_m - mirror.point_m, mirror.normal),
                     mirrored(p.outward, mirror.normal)};
    };
    press(across(from), across(to));
}

void Stroke::press(const Point& from, const Point& to) {
    const Vector3d way = to.position_m - from.position_m, outward = (from.outward + to.outward).normalized();
    const double length = way.norm();
    // Fibres lie in the tangent plane: the normal part of the path is removed.
    const Vector3d along = way - way.dot(outward) * outward;
    const Vector3d tangent = along.norm() > 1e-9 * length ? along.normalized() : Vector3d::Zero();
    const double above = brush_policy.above_surface * places_.edge_m;
    const double reach = brush_.radius_m + std::max(above, std::isfinite(brush_.depth_m) ? brush_.depth_m : 0.0) +
                         length;
    // Closest point on the segment, clamped to its ends; then height and radius relative to the mean surface normal.
    for (Index c = 0; c < places_.centre_m.cols(); ++c) {
        const Vector3d x = places_.centre_m.col(c) - from.position_m;
        if (std::isfinite(brush_.depth_m) && x.squaredNorm() > reach * reach) continue;
        const double share = length > 0.0 ? std::clamp(x.dot(way) / (length * length), 0.0, 1.0) : 0.0;
        const Vector3d beside = x - share * way;
        const double height = beside.dot(outward);
        if (height > above || height < -brush_.depth_m) continue;
        const double weight = brush_.weight((beside - height * outward).norm());
        if (!(weight > 0.0)) continue;
        // Maximum, not sum: overlapping segments of one stroke do not accumulate.
        weights_(c) = std::max(weights_(c), weight);
        const double pull = weight * length;
        dyads_[static_cast<std::size_t>(c)] += pull * tangent * tangent.transpose();
    }
}

CellPaint Stroke::over(const CellPaint& before, const Vector3d& otherwise) const {
    assert(before.count() == weights_.size());
    CellPaint paint = before;
    for (Index c = 0; c < weights_.size(); ++c) {
        const double weight = weights_(c);
        if (!(weight > 0.0)) continue;
        if (brush_.erase) {
            paint.weights(c) *= 1.0 - weight;
            if (paint.weights(c) < 1e-3) paint.weights(c) = 0.0, paint.directions.col(c).setZero();
            continue;
        }
        const Matrix3d& dyads = dyads_[static_cast<std::size_t>(c)];
        const bool was_painted = before.weights(c) > 0.0;
        paint.weights(c) = std::max(before.weights(c), weight);
        Matrix3d line;
        if (brush_.axis)
            line = *brush_.axis * brush_.axis->transpose();
        else if (dyads.trace() > 0.0)
            line = dyads / dyads.trace();
        else if (!was_painted)
            line = otherwise * otherwise.transpose();
        else
            continue;
        // The new stroke overrides the existing direction in proportion to its weight.
        if (was_painted)
            line = weight * line + (1.0 - weight) * before.directions.col(c) * before.directions.col(c).transpose();
        paint.directions.col(c) = mean_line(line);
    }
    return paint;
}

}  // namespace myo::fibre
