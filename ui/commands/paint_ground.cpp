#include "commands/paint_ground.hpp"

#include <Eigen/Geometry>

#include <functional>
#include <vector>

#include "fibre/direction_field.hpp"
#include "mesh/face_shape.hpp"

namespace myo::ui::commands {
namespace {

/// Corners of a triangle as columns [m].
Eigen::Matrix3d corners(const mesh::SurfaceMesh& surface, int triangle) {
    return surface.vertices(Eigen::all, surface.triangles.col(triangle));
}

/// Bounding box of each triangle [m].
std::vector<Box> boxes_of(const mesh::SurfaceMesh& surface) {
    std::vector<Box> boxes;
    for (int t = 0; t < static_cast<int>(surface.triangles.cols()); ++t)
        boxes.push_back(mesh::bounding_box(corners(surface, t)));
    return boxes;
}

}  // namespace

std::shared_ptr<const PaintGround> paint_ground(const mesh::SurfaceMesh& body_surface, const mesh::VolumeMesh& mesh,
                                                const Progress& progress) {
    auto ground = std::make_shared<PaintGround>();
    // Each part takes a good part of a second on a million cells, so the flag is checked before each.
    const std::function<void()> parts[] = {
        [&] { ground->neighbours = mesh::neighbouring_cells(mesh); },
        [&] { ground->places = fibre::cell_places(mesh, ground->neighbours); },
        [&] { ground->volumes_m3 = mesh::cell_volumes(mesh); },
        [&] { ground->longest_axis = fibre::directions_along_longest_axis(mesh).col(0); },
        [&] { ground->surface = body_surface; },
        [&] { ground->triangles = mesh::BoxTree(boxes_of(body_surface)); }};
    for (const std::function<void()>& part : parts) {
        if (progress.cancelled()) return nullptr;
        part();
    }
    const Box bounds = mesh::bounding_box(mesh.nodes);
    ground->middle_m = 0.5 * (bounds.lowest + bounds.highest);
    return ground;
}

Eigen::Vector3d outward_at(const PaintGround& ground, const Eigen::Vector3d& position_m) {
    // The tree holds boxes; the exact distance to a triangle is computed here.
    const auto squared_distance = [&](int t) {
        const Eigen::Matrix3Xd X = corners(ground.surface, t);
        return (X * mesh::face_shape(3, mesh::closest_face_parameters(X, position_m)) - position_m).squaredNorm();
    };
    const int nearest = ground.triangles.nearest(position_m, squared_distance);
    // A mesh without a surface of its own has no normal to offer.
    if (nearest < 0) return Eigen::Vector3d::UnitZ();
    const Eigen::Matrix3d X = corners(ground.surface, nearest);
    return (X.col(1) - X.col(0)).cross(X.col(2) - X.col(0)).normalized();
}

}  // namespace myo::ui::commands
