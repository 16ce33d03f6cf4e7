#include "backend/example_picture.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <numbers>
#include <utility>
#include <vector>

namespace myo::backend {
namespace {

/// View and shading of the picture.
struct PicturePolicy {
    double turn_deg = -35.0;    // about the vertical axis
    double tilt_deg = 25.0;     // from above
    double least_light = 0.45;  // of faces that turn away from the light
    Eigen::Index most = 20000;  // triangles
};
const PicturePolicy picture_policy;

/// Rows: to the right, down, towards the eye, in the mesh frame with z upwards. Left-handed, since y points down.
Eigen::Matrix3d camera() {
    constexpr double degree = std::numbers::pi / 180.0;
    // Turned about the vertical axis first, then tilted about the horizontal axis of the picture.
    const Eigen::Matrix3d turned = (Eigen::AngleAxisd(picture_policy.tilt_deg * degree, Eigen::Vector3d::UnitX()) *
                                    Eigen::AngleAxisd(picture_policy.turn_deg * degree, Eigen::Vector3d::UnitZ()))
                                       .toRotationMatrix();
    Eigen::Matrix3d rows;
    rows << turned.row(0), -turned.row(2), -turned.row(1);
    return rows;
}

}  // namespace

ui::commands::ExamplePicture picture_of(const mesh::SurfaceMesh& surface) {
    ui::commands::ExamplePicture picture;
    const Eigen::Index count = surface.triangles.cols();
    if (count == 0 || count > picture_policy.most) return picture;
    const Eigen::Matrix3Xd seen = camera() * surface.vertices;
    const Eigen::Vector2d lowest = seen.topRows<2>().rowwise().minCoeff(),
                          size = seen.topRows<2>().rowwise().maxCoeff() - lowest;
    const double longest = size.maxCoeff();
    // A body without extent has no scale.
    if (!(longest > 0.0)) return picture;
    picture.width = static_cast<float>(size.x() / longest);
    picture.height = static_cast<float>(size.y() / longest);
    std::vector<std::pair<double, ui::commands::ExamplePicture::Triangle>> drawn;
    for (Eigen::Index t = 0; t < count; ++t) {
        const Eigen::Matrix3d X = seen(Eigen::all, surface.triangles.col(t));
        const Eigen::Vector3d normal = (X.col(1) - X.col(0)).cross(X.col(2) - X.col(0)).normalized();
        // The frame is left-handed, as y points down: faces that are seen point away in it.
        if (!(normal.z() < 0.0)) continue;
        ui::commands::ExamplePicture::Triangle triangle;
        for (int k = 0; k < 3; ++k)
            for (int axis = 0; axis < 2; ++axis)
                triangle.corners[static_cast<std::size_t>(2 * k + axis)] = static_cast<float>(
                    (X(axis, k) - lowest(axis)) / longest);
        // Light falls from above: y points down, and visible normals point away from the eye, so both signs cancel.
        const double share = 0.5 * (1.0 + normal.y());
        triangle.light = static_cast<float>(picture_policy.least_light + (1.0 - picture_policy.least_light) * share);
        drawn.emplace_back(X.row(2).mean(), triangle);
    }
    // Painter's algorithm: near triangles cover far ones.
    std::stable_sort(drawn.begin(), drawn.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [depth, triangle] : drawn) picture.triangles.push_back(triangle);
    return picture;
}

}  // namespace myo::backend
