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

/// Red, green, blue, alpha, each 0 to 1.
using Color = Eigen::Vector4f;

/// A theme colour with the given opacity.
inline Color color_of(const ImVec4& color, float alpha = 1.0f) { return {color.x, color.y, color.z, alpha}; }

/// A marker in the view.
struct DrawnMarker {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  // [m]; not drawn if not finite
    Color color = Color::Ones();
    bool ring = false;  // ring (simulated) instead of a sphere (measured)
    std::string label;  // text next to it; may be empty
    int number = -1;    // index of the marker in the experiment; -1: cannot be picked
};

/// A text beside a point in the view.
struct DrawnLabel {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  // [m]
    std::string text;
    Color color = Color::Ones();
};

/// A line of the legend of the body's colours.
struct DrawnLegendEntry {
    std::string text;
    Color color = Color::Ones();
};

/// A polyline in the view.
struct DrawnLine {
    Eigen::Matrix3Xd points;  // 3 x n [m]; a column that is not finite interrupts the line
    Color color = Color::Ones();
    double width = 1.5;  // [pixels] at scale 1
};

/// A scalar field that colours the body.
struct DrawnField {
    std::string name;        // of the legend
    std::string unit;        // of the values and the legend
    double lowest = 0.0;     // value of the lowest colour
    double highest = 1.0;    // value of the highest colour
    bool diverging = false;  // diverging colours, with the middle of the range in the middle
    int color_map = 0;       // otherwise: index in color_maps()
    Eigen::VectorXd values;  // per node
};

/// Scale of force arrows, for the scale bar in the view.
struct ArrowScale {
    std::string name;           // of the force
    double metres_per_N = 1.0;  // length of an arrow per newton
    Color color = Color::Ones();
};

/// The part of a meshed body that is drawn.
struct DrawnBody {
    mesh::BoundaryFaces faces;  // in the order of the surface's faces
    std::vector<char> kept;     // per cell, 0 if it is cut away; empty: all cells are drawn

    /// Whether a cell is drawn.
    bool has(Eigen::Index cell) const { return kept.empty() || kept[static_cast<std::size_t>(cell)] != 0; }
};

/// Everything that a 3D view shows, as a value. Surface and body are shared with the workbench and never changed.
struct DrawnScene {
    std::shared_ptr<const DrawnSurface> surface;  // null: no surface is drawn
    std::shared_ptr<const DrawnBody> body;        // body that the surface belongs to; null: not meshed
    Eigen::Matrix3Xd positions;                   // of the nodes that the surface refers to, 3 x n [m]
    std::optional<DrawnField> field;              // empty: the body has one colour
    Eigen::Matrix4Xf tints;       // per face of the body: red, green, blue and opacity of the tint; may be empty
    double body_opacity = 1.0;    // 0 to 1
    bool edges = true;            // element edges
    bool grid = true;             // ground grid
    double marker_radius = 1e-3;  // [m]
    std::vector<DrawnMarker> markers;
    std::vector<DrawnLine> lines;
    std::vector<DrawnLabel> labels;        // of loads, gravity and parts; markers have their own
    std::vector<DrawnLegendEntry> legend;  // of the colours of the body's parts; not with a field
    std::optional<ArrowScale> arrows;      // set if some of the lines are force arrows
    Box extent;                            // of the rest shape [m]: sets the grid
    Box reach;                             // of the whole motion [m]: shown by "zoom to data"
};

/// Colours of the view that depend on the theme only.
struct ViewColors {
    Color top, bottom, grid, body, edge;  // background (top, bottom), ground grid, body, element edges
    bool transparent = false;             // no background: the image has an alpha channel
};
/// The view's colours in a theme.
ViewColors view_colors(const platform::Theme& theme);

}  // namespace myo::ui::viewport
