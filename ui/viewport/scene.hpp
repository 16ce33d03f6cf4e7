#pragma once

#include <Eigen/Core>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mesh/surface_mesh.hpp"
#include "platform/theme.hpp"
#include "viewport/camera.hpp"
#include "viewport/drawn_surface.hpp"

namespace myo::ui::viewport {

/// Red, green, blue, alpha, 0 to 1.
using Color = Eigen::Vector4f;

inline Color color_of(const ImVec4& color, float alpha = 1.0f) { return {color.x, color.y, color.z, alpha}; }

struct DrawnMarker {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  // [m]; not drawn when not finite
    Color color = Color::Ones();
    bool ring = false;  // a ring instead of a sphere
    std::string label;  // beside it, may be empty
    int number = -1;    // of the marker in the experiment
};

struct DrawnLine {
    Eigen::Matrix3Xd points;  // polyline [m]; a gap where not finite
    Color color = Color::Ones();
    double width = 1.5;  // [pixels]
};

/// A scalar per node, mapped to colours.
struct DrawnField {
    std::string name;
    std::string unit;
    double lowest = 0.0;
    double highest = 1.0;
    bool diverging = false;  // colours part in the middle of the range
    int color_map = 0;       // else which of color_maps()
    Eigen::VectorXd values;
};

/// What the lengths of arrows mean.
struct ArrowScale {
    std::string name;
    double metres_per_N = 1.0;
    Color color = Color::Ones();
};

/// What is drawn of a meshed body.
struct DrawnBody {
    mesh::BoundaryFaces faces;  // in the order of the surface's
    std::vector<char> kept;     // per cell, 0 where it is cut away; empty: all are drawn

    bool has(Eigen::Index cell) const { return kept.empty() || kept[static_cast<std::size_t>(cell)] != 0; }
};

/// All that a 3D view shows, as a value.
struct DrawnScene {
    std::shared_ptr<const DrawnSurface> surface;
    std::shared_ptr<const DrawnBody> body;  // that the surface belongs to; null: not meshed
    Eigen::Matrix3Xd positions;             // of the nodes the surface refers to [m]
    std::optional<DrawnField> field;
    Eigen::Matrix4Xf tints;  // per face of the body: red, green, blue and the share of that colour; may be empty
    double body_opacity = 1.0;
    bool edges = true;
    bool grid = true;
    double marker_radius = 1e-3;  // [m]
    std::vector<DrawnMarker> markers;
    std::vector<DrawnLine> lines;
    std::optional<ArrowScale> arrows;  // where some of the lines are arrows of a force
    Box extent;                        // of the rest shape: sets the grid
    Box reach;                         // of the whole motion: what "fit" shows
};

struct ViewColors {
    Color top, bottom, grid, body, edge;
};
ViewColors view_colors(const platform::Theme& theme);

}  // namespace myo::ui::viewport
