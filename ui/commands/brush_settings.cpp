#include "commands/brush_settings.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace myo::ui::commands {

namespace {

/// Area of all triangles [m²].
double surface_area(const mesh::SurfaceMesh& surface) {
    double area_m2 = 0.0;
    for (Eigen::Index t = 0; t < surface.triangles.cols(); ++t) {
        const Eigen::Matrix3d X = surface.vertices(Eigen::all, surface.triangles.col(t));
        area_m2 += 0.5 * (X.col(1) - X.col(0)).cross(X.col(2) - X.col(0)).norm();
    }
    return area_m2;
}

}  // namespace

BrushSettings brush_for(const mesh::SurfaceMesh& surface) {
    const Eigen::Vector3d size_m = mesh::bounding_box(surface.vertices).size();
    BrushSettings brush;
    // Multiples of half a millimetre, as a user would type them.
    const auto rounded = [](double metres) { return std::max(1.0, std::round(metres / 5e-4)) * 5e-4; };
    brush.radius_m = rounded(0.06 * size_m.norm());
    // Twice the volume over the area is the thickness of a plate and half of that of a rod. A body that tapers is
    // thinner than its box: a muscle on one of its sides must not come out on the other.
    const double area_m2 = surface_area(surface),
                 plate_m = area_m2 > 0.0 ? 2.0 * mesh::enclosed_volume(surface) / area_m2 : size_m.minCoeff();
    brush.depth_m = rounded(std::min(0.4 * size_m.minCoeff(), plate_m > 0.0 ? 0.6 * plate_m : size_m.minCoeff()));
    return brush;
}

Eigen::Vector3d fixed_axis(BrushDirection direction, const PaintGround& ground) {
    switch (direction) {
        case BrushDirection::x: return Eigen::Vector3d::UnitX();
        case BrushDirection::y: return Eigen::Vector3d::UnitY();
        case BrushDirection::z: return Eigen::Vector3d::UnitZ();
        // Without a stroke direction (a fill, or a single click) the longest axis is the best guess.
        case BrushDirection::stroke:
        case BrushDirection::longest: break;
    }
    return ground.longest_axis;
}

fibre::Brush make_brush(const BrushSettings& settings, const PaintGround& ground, bool erase) {
    fibre::Brush brush;
    // A cell is painted if its centre lies in the brush. On a coarse mesh a small brush must still reach the cell under
    // it.
    const double min_m = 0.6 * ground.places.edge_m;
    brush.radius_m = std::max(settings.radius_m, min_m);
    brush.depth_m = settings.through ? std::numeric_limits<double>::infinity() : std::max(settings.depth_m, min_m);
    brush.falloff = settings.falloff;
    brush.strength = settings.strength;
    brush.erase = erase;
    if (settings.direction != BrushDirection::stroke) brush.axis = fixed_axis(settings.direction, ground);
    if (settings.mirror != BrushMirror::none) {
        const int axis = settings.mirror == BrushMirror::x ? 0 : settings.mirror == BrushMirror::y ? 1 : 2;
        brush.mirror = fibre::MirrorPlane{ground.middle_m, Eigen::Vector3d::Unit(axis)};
    }
    return brush;
}

}  // namespace myo::ui::commands
