#include "commands/obstacle_lines.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <numbers>

#include "viewport/scene_lines.hpp"

namespace myo::ui::commands {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr double patch_half = 0.6;     // half an edge of a plane's patch over the diagonal of the body
constexpr double normal_length = 0.1;  // of the arrow, over the same
constexpr int squares = 10;            // of a patch, along each edge
constexpr int circles = 4;             // of latitude on each half of a sphere, and of longitude
constexpr int pieces = 48;             // of a circle
constexpr float grid_alpha = 0.6f;     // of the lines within a patch, over that of its edge

/// A point that ends a polyline: lines are not drawn to it.
Vector3d gap() { return Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()); }

/// Points as columns, 3 x n.
Matrix3Xd columns(const std::vector<Vector3d>& points) {
    Matrix3Xd matrix(3, static_cast<Index>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) matrix.col(static_cast<Index>(i)) = points[i];
    return matrix;
}

/// A square of the plane around the foot of the body's middle: grid, edge, and an arrow of the normal at a corner.
std::vector<viewport::DrawnLine> plane_lines(const ScenePlane& plane, const Box& extent, const viewport::Color& color,
                                             double width) {
    const double diagonal = extent.size().norm(), half = patch_half * diagonal;
    const Vector3d middle = 0.5 * (extent.lowest + extent.highest);
    // Foot of the perpendicular: a plane is infinite, and the patch is drawn where the body is.
    const Vector3d centre = middle - plane.normal.dot(middle - plane.point_m) * plane.normal;
    const Vector3d u = plane.normal.unitOrthogonal(), v = plane.normal.cross(u);
    const auto at = [&](double a, double b) { return Vector3d(centre + half * (a * u + b * v)); };
    std::vector<Vector3d> grid;
    for (int i = 1; i < squares; ++i) {
        const double a = 2.0 * i / squares - 1.0;
        for (const Vector3d& point : {at(a, -1.0), at(a, 1.0), gap(), at(-1.0, a), at(1.0, a), gap()})
            grid.push_back(point);
    }
    viewport::Color faint = color;
    faint[3] *= grid_alpha;
    return {{columns(grid), faint, 0.7 * width},
            {columns({at(-1.0, -1.0), at(1.0, -1.0), at(1.0, 1.0), at(-1.0, 1.0), at(-1.0, -1.0)}), color, width},
            {viewport::arrow_points(at(-1.0, -1.0), normal_length * diagonal * plane.normal), color, width}};
}

/// Circles of latitude and of longitude.
std::vector<viewport::DrawnLine> sphere_lines(const SceneSphere& sphere, const viewport::Color& color, double width) {
    const auto at = [&](double latitude, double longitude) {
        return Vector3d(sphere.centre_m + sphere.radius_m * Vector3d(std::cos(latitude) * std::cos(longitude),
                                                                     std::cos(latitude) * std::sin(longitude),
                                                                     std::sin(latitude)));
    };
    constexpr double pi = std::numbers::pi;
    std::vector<Vector3d> points;
    for (int c = 1 - circles; c < circles; ++c) {
        for (int i = 0; i <= pieces; ++i) points.push_back(at(0.5 * pi * c / circles, 2.0 * pi * i / pieces));
        points.push_back(gap());
    }
    for (int c = 0; c < circles; ++c) {
        for (int i = 0; i <= pieces; ++i) points.push_back(at(2.0 * pi * i / pieces, pi * c / circles));
        points.push_back(gap());
    }
    return {{columns(points), color, width}};
}

}  // namespace

std::vector<viewport::DrawnLine> obstacle_lines(const SceneObstacle& obstacle, const Box& extent,
                                                const viewport::Color& color, double width) {
    if (const auto* plane = std::get_if<ScenePlane>(&obstacle.shape)) return plane_lines(*plane, extent, color, width);
    if (const auto* sphere = std::get_if<SceneSphere>(&obstacle.shape)) return sphere_lines(*sphere, color, width);
    return viewport::box_lines(std::get<Box>(obstacle.shape), color, width);
}

}  // namespace myo::ui::commands
