#include "fibre/polyline.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

namespace myo::fibre {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

struct Segment {
    Vector3d start, tangent;
    double length;
};

Segment segment(const Polyline& line, Index i) {
    const Vector3d along = line.points_m.col(i + 1) - line.points_m.col(i);
    const double length = along.norm();
    assert(length > 0.0);
    return {line.points_m.col(i), along / length, length};
}

/// Bisector of two tangents; the first one if the line reverses.
Vector3d half_way(const Vector3d& a, const Vector3d& b) {
    const Vector3d sum = a + b;
    return sum.norm() > 1e-6 ? Vector3d(sum.normalized()) : a;
}

}  // namespace

double Polyline::length_m() const {
    double sum = 0.0;
    for (Index i = 0; i < segment_count(); ++i) sum += (points_m.col(i + 1) - points_m.col(i)).norm();
    return sum;
}

BesideLine beside_line(const Polyline& line, const Vector3d& x) {
    assert(line.segment_count() >= 1);
    const Index last = line.segment_count() - 1;
    Index nearest = 0;
    // Nearest segment by clamped projection.
    double least = std::numeric_limits<double>::infinity(), at = 0.0;
    for (Index i = 0; i <= last; ++i) {
        const Segment s = segment(line, i);
        const double along = (x - s.start).dot(s.tangent), t = std::clamp(along, 0.0, s.length);
        const double squared_distance = (x - s.start - t * s.tangent).squaredNorm();
        if (squared_distance < least) least = squared_distance, nearest = i, at = along;
    }
    const Segment s = segment(line, nearest);
    // Only the first and last segment are extended beyond their ends, where the flat end planes are.
    BesideLine beside{0.0, std::numeric_limits<double>::infinity(), s.tangent, Vector3d::Zero()};
    double t = at;
    if (nearest == 0)
        beside.inward_m = at;
    else
        t = std::max(t, 0.0);
    if (nearest == last)
        beside.inward_m = std::min(beside.inward_m, s.length - at);
    else
        t = std::min(t, s.length);
    const Vector3d across = x - s.start - t * s.tangent;
    beside.distance_m = across.norm();
    if (beside.distance_m > 0.0) beside.away = across / beside.distance_m;
    if (nearest < last && at >= s.length)
        beside.tangent = half_way(s.tangent, segment(line, nearest + 1).tangent);
    else if (nearest > 0 && at <= 0.0)
        beside.tangent = half_way(segment(line, nearest - 1).tangent, s.tangent);
    return beside;
}

double depth_in_tube(const BesideLine& beside, double radius_m) {
    return std::min(radius_m - beside.distance_m, beside.inward_m);
}

}  // namespace myo::fibre
