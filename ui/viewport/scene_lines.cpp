#include "viewport/scene_lines.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

#include "chart/ticks.hpp"

namespace myo::ui::viewport {
namespace {

/// One segment: both ends [m] and the colour, 10 floats.
void append(std::vector<float>& segments, const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Color& color) {
    for (int k = 0; k < 3; ++k) segments.push_back(static_cast<float>(from[k]));
    for (int k = 0; k < 3; ++k) segments.push_back(static_cast<float>(to[k]));
    for (int k = 0; k < 4; ++k) segments.push_back(color[k]);
}

}  // namespace

void append_segments(std::vector<float>& segments, const DrawnLine& line) {
    for (Eigen::Index i = 1; i < line.points.cols(); ++i) {
        if (!line.points.col(i - 1).allFinite() || !line.points.col(i).allFinite()) continue;
        append(segments, line.points.col(i - 1), line.points.col(i), line.color);
    }
}

std::vector<float> grid_segments(const Box& extent, const Color& color) {
    std::vector<float> segments;
    // About five squares along the longest side, with a size that is easy to read.
    const double reach = extent.size().maxCoeff();
    if (!(reach > 0.0)) return segments;
    const double cell = chart::round_step(reach / 5.0);
    const Eigen::Vector3d center = 0.5 * (extent.lowest + extent.highest);
    // Lines at multiples of the square, so that the grid does not move with small changes of the body.
    const double x0 = std::round(center.x() / cell) * cell;
    const double y0 = std::round(center.y() / cell) * cell;
    // A quarter of the body's height below it leaves room for a body that sags.
    const double z = extent.lowest.z() - 0.25 * extent.size().z();
    constexpr int half = 8;
    const auto point = [&](int i, int j) { return Eigen::Vector3d(x0 + i * cell, y0 + j * cell, z); };
    const auto faded = [&](int i, int j) {
        Color c = color;
        const double r = std::hypot(i, j) / half;
        c[3] *= static_cast<float>(std::clamp(1.0 - r * r, 0.0, 1.0));
        return c;
    };
    for (int i = -half; i <= half; ++i) {
        for (int j = -half; j < half; ++j) {
            // Each piece has one colour. That is enough for a smooth fade, as the alpha changes slowly.
            append(segments, point(i, j), point(i, j + 1), faded(i, j < 0 ? j + 1 : j));
            append(segments, point(j, i), point(j + 1, i), faded(j < 0 ? j + 1 : j, i));
        }
    }
    return segments;
}

Eigen::Matrix<double, 3, 10> arrow_points(const Eigen::Vector3d& from, const Eigen::Vector3d& along) {
    const Eigen::Vector3d tip = from + along, side = 0.09 * along.norm() * along.unitOrthogonal(),
                          other = along.normalized().cross(side);
    const Eigen::Vector3d neck = tip - 0.25 * along;
    Eigen::Matrix<double, 3, 10> points;
    points << from, tip, neck + side, tip, neck - side, tip, neck + other, tip, neck - other,
        Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    return points;
}

std::vector<DrawnLine> box_lines(const Box& box, const Color& color, double width) {
    const auto corner = [&](int bits) {
        return Eigen::Vector3d(bits & 1 ? box.highest.x() : box.lowest.x(), bits & 2 ? box.highest.y() : box.lowest.y(),
                               bits & 4 ? box.highest.z() : box.lowest.z());
    };
    std::vector<DrawnLine> lines;
    // Each edge starts at the corner whose bit for its axis is 0, so that it is created once.
    for (int bits = 0; bits < 8; ++bits) {
        for (int axis = 0; axis < 3; ++axis) {
            if (bits & (1 << axis)) continue;
            DrawnLine line;
            line.points.resize(3, 2);
            line.points.col(0) = corner(bits);
            line.points.col(1) = corner(bits | (1 << axis));
            line.color = color;
            line.width = width;
            lines.push_back(line);
        }
    }
    return lines;
}

}  // namespace myo::ui::viewport
