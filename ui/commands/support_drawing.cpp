#include "commands/support_drawing.hpp"

#include "mesh/surface_mesh.hpp"
#include "viewport/scene_lines.hpp"

namespace myo::ui::commands {
namespace {

using Eigen::Vector3d;

/// How the held axes of a support are drawn.
struct SupportLookPolicy {
    double bar = 0.06;   // half length, over the diagonal of the body
    double stop = 0.02;  // half length of the stops at the ends, over the diagonal
    double width = 2.0;  // [pixels]
};
constexpr SupportLookPolicy support_look_policy;

/// Adds a line between two points.
void add_line(viewport::DrawnScene& drawn, const Vector3d& from, const Vector3d& to, const viewport::Color& color,
              double width) {
    Eigen::Matrix3Xd points(3, 2);
    points << from, to;
    drawn.lines.push_back({std::move(points), color, width});
}

/// A bar along an axis with a stop across each end: motion along it is blocked.
void add_bar(viewport::DrawnScene& drawn, const Vector3d& middle, Eigen::Index axis, double diagonal,
             const viewport::Color& color) {
    const Vector3d along = support_look_policy.bar * diagonal * Vector3d::Unit(axis);
    add_line(drawn, middle - along, middle + along, color, support_look_policy.width);
    for (const Vector3d& end : {Vector3d(middle - along), Vector3d(middle + along)})
        for (const Eigen::Index across : {(axis + 1) % 3, (axis + 2) % 3}) {
            const Vector3d half = support_look_policy.stop * diagonal * Vector3d::Unit(across);
            add_line(drawn, end - half, end + half, color, support_look_policy.width);
        }
}

}  // namespace

void add_supports(viewport::DrawnScene& drawn, const WorkbenchState& state, const platform::Theme& theme) {
    const Box body = mesh::bounding_box(state.scene->surface.vertices);
    const double diagonal = body.size().norm();
    for (std::size_t i = 0; i < state.scene->supports.size(); ++i) {
        const SceneSupport& support = state.scene->supports[i];
        const bool edited = state.view.edited == "support/more/" + std::to_string(i);
        const viewport::Color color = edited ? viewport::color_of(theme.accent) : viewport::color_of(theme.muted, 0.9f);
        for (viewport::DrawnLine& line : viewport::box_lines(support.box_m, color, edited ? 2.5 : 1.5))
            drawn.lines.push_back(std::move(line));
        // A box may reach far beyond the body; the mark belongs where it holds material.
        const Vector3d lowest = support.box_m.lowest.cwiseMax(body.lowest),
                       highest = support.box_m.highest.cwiseMin(body.highest);
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            if (support.held[static_cast<std::size_t>(axis)])
                add_bar(drawn, 0.5 * (lowest + highest), axis, diagonal, color);
    }
}

}  // namespace myo::ui::commands
