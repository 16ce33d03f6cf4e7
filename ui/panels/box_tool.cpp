#include "panels/box_tool.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "panels/declared_rows.hpp"
#include "panels/escape.hpp"
#include "panels/view_points.hpp"
#include "panels/widgets.hpp"
#include "plot/number_text.hpp"
#include "viewport/picking.hpp"

namespace myo::ui::panels {
namespace {

/// Sizes of handles on the screen, and steps in which sides move.
struct BoxToolPolicy {
    float radius = 5.0f, reach = 9.0f;  // of a handle, drawn and to be pressed [pixels at scale 1]
    double steps_per_m = 1e5;           // sides are rounded to 0.01 mm, so that their texts are short
    double least_side = 1e-5;           // [m] a box keeps
    double seen_axis = 0.05;  // part of an axis across the line of sight, below which a drag along it has no place
};
constexpr BoxToolPolicy box_tool_policy;

/// Coordinate along an axis through `place` that a pixel leads to [m]; empty if the axis points to the eye.
std::optional<double> along_axis(const viewport::ViewportState& view, const Eigen::Vector2d& pixel,
                                 const Eigen::Vector3d& place, int axis) {
    const Eigen::Vector3d moved = viewport::in_image_plane(view.camera, view.size(), pixel, place) - place;
    const viewport::Ray ray = viewport::ray_through(view.camera, view.size(), pixel);
    const Eigen::Vector3d unit = Eigen::Vector3d::Unit(axis);
    // The part of the axis that lies in the plane of the image: where the mouse leads is compared within that plane.
    const Eigen::Vector3d seen = unit - unit.dot(ray.direction) * ray.direction;
    if (seen.squaredNorm() < box_tool_policy.seen_axis * box_tool_policy.seen_axis) return std::nullopt;
    return place(axis) + moved.dot(seen) / seen.squaredNorm();
}

/// Pairs of corners, numbered by the bits x, y, z, that are the edges of a box.
constexpr std::array<std::array<int, 2>, 12> box_edges{
    {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};

/// A corner by its number: bit k stands for the upper side along axis k.
Eigen::Vector3d corner_of(const Box& box, int corner) {
    Eigen::Vector3d at = box.lowest;
    for (int axis = 0; axis < 3; ++axis)
        if ((corner >> axis) & 1) at(axis) = box.highest(axis);
    return at;
}

}  // namespace

Eigen::Vector3d BoxTool::place_of(const Box& box, int axis, bool upper) {
    Eigen::Vector3d place = 0.5 * (box.lowest + box.highest);
    place(axis) = (upper ? box.highest : box.lowest)(axis);
    return place;
}

std::optional<BoxTool::Handle> BoxTool::handle_at(const platform::Theme& theme, const viewport::ViewportState& view,
                                                  const Eigen::Vector2d& pixel) const {
    std::optional<Handle> nearest;
    double least = static_cast<double>(box_tool_policy.reach * theme.scale);
    for (std::size_t b = 0; b < boxes_.size(); ++b)
        for (int axis = 0; axis < 3; ++axis)
            for (const bool upper : {false, true}) {
                const auto seen = viewport::project(view.camera, view.size(), place_of(boxes_[b].box, axis, upper));
                if (!seen || !((seen->head<2>() - pixel).norm() <= least)) continue;
                least = (seen->head<2>() - pixel).norm();
                nearest = Handle{b, axis, upper};
            }
    return nearest;
}

bool BoxTool::takes(const commands::WorkbenchState& state, const platform::Theme& theme,
                    const viewport::ViewportState& view, const Eigen::Vector2d& pixel) const {
    // Live play, brush and measuring have the mouse first; Shift leaves the drag to the camera.
    return !state.live && state.brush.tool == commands::BrushTool::none && !view.measuring &&
           !ImGui::GetIO().KeyShift && handle_at(theme, view, pixel).has_value();
}

Box BoxTool::dragged() const {
    Box box = drag_->at_start.box;
    const int axis = drag_->handle.axis;
    if (drag_->handle.upper)
        box.highest(axis) = std::max(drag_->side_m, box.lowest(axis) + box_tool_policy.least_side);
    else
        box.lowest(axis) = std::min(drag_->side_m, box.highest(axis) - box_tool_policy.least_side);
    return box;
}

void BoxTool::update(PanelContext& context, const viewport::ViewportState& view) {
    const bool held = view.tool_held, pressed = held && !was_held_;
    was_held_ = held;
    if (pressed && takes(context.state, context.theme, view, view.mouse)) {
        const Handle handle = *handle_at(context.theme, view, view.mouse);
        const Eigen::Vector3d place = place_of(boxes_[handle.box].box, handle.axis, handle.upper);
        // The offset keeps the side in place although the mouse is not exactly on the middle of its handle.
        if (const auto at = along_axis(view, view.mouse, place, handle.axis))
            drag_ = Drag{handle, boxes_[handle.box], place(handle.axis) - *at, place(handle.axis)};
    } else if (drag_ && held) {
        const Eigen::Vector3d place = place_of(drag_->at_start.box, drag_->handle.axis, drag_->handle.upper);
        if (const auto at = along_axis(view, view.mouse, place, drag_->handle.axis)) {
            // Sides are multiples of a step: a difference of more than half a step is a move, a smaller one is
            // rounding.
            const double side = std::round((*at + drag_->offset_m) * box_tool_policy.steps_per_m) /
                                box_tool_policy.steps_per_m;
            drag_->moved = drag_->moved || std::abs(side - drag_->side_m) > 0.5 / box_tool_policy.steps_per_m;
            drag_->side_m = side;
        }
    }
    // Escape drops the drag before anything is emitted, so that the declaration stays as it was.
    if (drag_ && escape_closes()) drag_.reset();
    draw(context, view);
    if (!drag_ || held) return;
    if (drag_->moved)
        context.emit(commands::EditDeclaration{{commands::SetDeclared{drag_->at_start.path, box_text(dragged())}},
                                               drag_->at_start.name + "/drag"});
    drag_.reset();
}

void BoxTool::draw(PanelContext& context, const viewport::ViewportState& view) const {
    const platform::Theme& theme = context.theme;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 color = platform::packed(theme.accent), dark = IM_COL32(0, 0, 0, 160);
    const auto hovered = drag_ || !view.hovered ? std::nullopt : handle_at(theme, view, view.mouse);
    for (std::size_t b = 0; b < boxes_.size(); ++b) {
        // The list of boxes may differ from that at the press, so the dragged box is found by its place in the
        // declaration.
        const bool is_dragged = drag_ && boxes_[b].path == drag_->at_start.path;
        const Box box = is_dragged ? dragged() : boxes_[b].box;
        for (const auto& [from, to] : box_edges) {
            const auto a = window_pixel(view, corner_of(box, from)), c = window_pixel(view, corner_of(box, to));
            if (a && c) list.AddLine(*a, *c, color, 1.0f * theme.scale);
        }
        for (int axis = 0; axis < 3; ++axis)
            for (const bool upper : {false, true}) {
                const auto at = window_pixel(view, place_of(box, axis, upper));
                if (!at) continue;
                const Handle* const active = is_dragged ? &drag_->handle : hovered ? &*hovered : nullptr;
                const bool lit = active && active->axis == axis && active->upper == upper &&
                                 (is_dragged || active->box == b);
                const float radius = (lit ? 1.4f : 1.0f) * box_tool_policy.radius * theme.scale;
                list.AddCircleFilled(*at, radius + 1.5f * theme.scale, dark);
                list.AddCircleFilled(*at, radius, color);
                // Tests press within the reach of the handle, which is wider than its circle.
                const float reach = box_tool_policy.reach * theme.scale;
                context.items.add("view/" + boxes_[b].name + "/" + axis_names[static_cast<std::size_t>(axis)] +
                                      (upper ? "_to" : "_from"),
                                  {{at->x - reach, at->y - reach}, {at->x + reach, at->y + reach}});
                if (is_dragged && lit)
                    draw_note(list, theme, {at->x + 2.0f * radius, at->y + radius},
                              std::string(axis_names[static_cast<std::size_t>(axis)]) + " = " +
                                  plot::millimetres((upper ? box.highest : box.lowest)(axis)));
            }
    }
}

}  // namespace myo::ui::panels
