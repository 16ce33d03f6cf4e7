#include "viewport/picking.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <limits>

namespace myo::ui::viewport {

using Eigen::Vector3d;

Ray ray_through(const Camera& camera, const ViewSize& size, const Eigen::Vector2d& pixel) {
    const CameraAxes axes = camera_axes(camera);
    const double scale = metres_per_pixel(camera, size);
    const Eigen::Vector2d from_middle = pixel - 0.5 * Eigen::Vector2d(size.width, size.height);
    const Vector3d aside = scale * (from_middle.x() * axes.right - from_middle.y() * axes.up);
    // In a parallel projection all rays have the same direction; the pixel shifts the origin instead.
    if (camera.orthographic) return {camera.target + aside + eye_distance(camera) * axes.back, -axes.back};
    const Vector3d eye = camera.target + camera.distance * axes.back;
    return {eye, (camera.target + aside - eye).normalized()};
}

Vector3d SurfaceHit::place(const DrawnSurface& surface, const Eigen::Matrix3Xd& positions_m) const {
    Vector3d sum = Vector3d::Zero();
    for (int k = 0; k < 3; ++k)
        sum += weights[k] * positions_m.col(surface.corners[static_cast<std::size_t>(3 * triangle + k)]);
    return sum;
}

std::optional<SurfaceHit> pick_surface(const DrawnSurface& surface, const Eigen::Matrix3Xd& positions_m,
                                       const Ray& ray) {
    std::optional<SurfaceHit> best;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t t = 0; t < surface.triangle_count(); ++t) {
        const Vector3d a = positions_m.col(surface.corners[3 * t]);
        const Vector3d ab = positions_m.col(surface.corners[3 * t + 1]) - a,
                       ac = positions_m.col(surface.corners[3 * t + 2]) - a;
        // Moeller and Trumbore 1997: ray parameter and two barycentric coordinates by Cramer's rule.
        const Vector3d p = ray.direction.cross(ac);
        const double determinant = ab.dot(p);  // positive if the ray meets the outside
        // The back of a closed body is not visible, so a ray that starts inside it must not hit.
        if (surface.closed ? !(determinant > 0.0) : determinant == 0.0) continue;
        const Vector3d s = ray.origin_m - a, q = s.cross(ab);
        const double u = s.dot(p) / determinant, v = ray.direction.dot(q) / determinant;
        if (u < 0.0 || v < 0.0 || u + v > 1.0) continue;
        const double distance = ac.dot(q) / determinant;
        if (!(distance > 0.0 && distance < nearest)) continue;
        nearest = distance;
        best = SurfaceHit{static_cast<int>(t), {1.0 - u - v, u, v}, distance};
    }
    return best;
}

Vector3d in_image_plane(const Camera& camera, const ViewSize& size, const Eigen::Vector2d& pixel,
                        const Vector3d& place_m) {
    const Ray ray = ray_through(camera, size, pixel);
    const Vector3d back = camera_axes(camera).back;
    return ray.origin_m + back.dot(place_m - ray.origin_m) / back.dot(ray.direction) * ray.direction;
}

}  // namespace myo::ui::viewport
