#include "panels/paint_tool.hpp"

#include <imgui.h>

#include <Eigen/Geometry>

#include <numbers>
#include <utility>
#include <vector>

#include "commands/picked_place.hpp"
#include "commands/setup_drawing.hpp"
#include "panels/escape.hpp"

namespace myo::ui::panels {
namespace {

/// Minimum distance between points of a stroke, as share of the radius. Closer points would take the tremor of the hand
/// for a direction.
constexpr double closest_points = 0.08;

/// The tool needs a mesh prepared for painting, and a part or a selected muscle.
bool can_paint(const commands::WorkbenchState& state) {
    return !state.live && state.brush.tool != commands::BrushTool::none && state.ground && state.brush_paint();
}

/// The brush that paints: an element belongs to a part or not, so that parts have neither soft edges nor strength.
commands::BrushSettings used_brush(const commands::WorkbenchState& state) {
    commands::BrushSettings brush = state.brush;
    if (brush.part >= 0) brush.falloff = 0.0, brush.strength = 1.0;
    return brush;
}

/// Emits finished paint of the part or muscle.
void hand_over(PanelContext& context, fibre::CellPaint painted, const char* what) {
    const commands::WorkbenchState& state = context.state;
    auto paint = std::make_shared<const fibre::CellPaint>(std::move(painted));
    if (state.brush.part >= 0)
        context.emit(commands::PaintPart{static_cast<std::size_t>(state.brush.part), std::move(paint)});
    else
        context.emit(commands::Paint{state.muscle, std::move(paint), what});
}

/// Ctrl swaps painting and erasing.
bool erases(const commands::BrushSettings& brush) {
    return (brush.tool == commands::BrushTool::erase) != ImGui::GetIO().KeyCtrl;
}

/// Frame of a triangle: two edges and the normal. The quotient of two frames is the deformation in its plane.
Eigen::Matrix3d frame_of(const viewport::DrawnSurface& surface, const Eigen::Matrix3Xd& positions, int triangle) {
    const auto corner = [&](int k) {
        return Eigen::Vector3d(positions.col(surface.corners[static_cast<std::size_t>(3 * triangle + k)]));
    };
    Eigen::Matrix3d frame;
    frame.col(0) = corner(1) - corner(0);
    frame.col(1) = corner(2) - corner(0);
    frame.col(2) = frame.col(0).cross(frame.col(1)).normalized();
    return frame;
}

/// Closed line in the colour of what the brush does.
void draw_outline(const PanelContext& context, const std::vector<ImVec2>& pixels) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec4 color = erases(state.brush) && state.brush.tool != commands::BrushTool::fill ? theme.failure
                         : state.brush.part >= 0
                             ? commands::part_color(state, theme, static_cast<std::size_t>(state.brush.part))
                             : theme.muscle(state.chosen_muscle()->color);
    // Dark below light, so that the ring is visible on any background.
    list.AddPolyline(pixels.data(), static_cast<int>(pixels.size()), IM_COL32(0, 0, 0, 160), ImDrawFlags_Closed,
                     3.5f * theme.scale);
    list.AddPolyline(pixels.data(), static_cast<int>(pixels.size()), platform::packed(color), ImDrawFlags_Closed,
                     1.8f * theme.scale);
}

}  // namespace

bool PaintTool::takes(const commands::WorkbenchState& state, const viewport::DrawnScene& scene,
                      const viewport::ViewportState& view, const Eigen::Vector2d& pixel) const {
    return can_paint(state) && !ImGui::GetIO().KeyShift &&
           commands::hit_on_body(state, scene, view.camera, view.size(), pixel).has_value();
}

/// The revision changes only if something was shown, so that the view is not rendered without need.
void PaintTool::drop() {
    stroke_.reset();
    ground_.reset();
    handed_over_ = false;
    if (live_) ++revision_;
    live_.reset();
}

void PaintTool::press(PanelContext& context, const viewport::DrawnScene& scene, const Touch& touch) {
    const commands::WorkbenchState& state = context.state;
    // Fill acts at the press; the other tools begin a stroke.
    if (state.brush.tool != commands::BrushTool::fill) {
        drop();
        ground_ = state.ground;
        muscle_ = state.muscle;
        part_ = state.brush.part;
        stroke_ = std::make_unique<fibre::Stroke>(
            ground_->places, commands::make_brush(used_brush(state), *ground_, erases(state.brush)));
        return;
    }
    // From the cell under the mouse over its neighbours, up to cells that are painted.
    fibre::CellPaint paint = fibre::filled(*state.brush_paint(), state.body->mesh, state.ground->neighbours,
                                           scene.body->faces.cell(touch.face),
                                           commands::fixed_axis(state.brush.direction, *state.ground));
    hand_over(context, std::move(paint), "fill");
}

/// Extends the stroke by the place under the mouse and updates the paint that the view shows.
void PaintTool::go_on(const commands::WorkbenchState& state, const Touch& touch) {
    // Points too close to the last one are skipped; see closest_points.
    if (live_ && (touch.rest_m - last_).norm() < closest_points * state.brush.radius_m) return;
    last_ = touch.rest_m;
    stroke_->add(touch.rest_m, touch.outward);
    live_ = stroke_->over(*state.brush_paint(), commands::fixed_axis(state.brush.direction, *ground_));
    ++revision_;
}

/// Escape, another mesh and another muscle or part end a stroke without a result.
void PaintTool::update(PanelContext& context, const viewport::DrawnScene& scene, const viewport::ViewportState& view) {
    const commands::WorkbenchState& state = context.state;
    const bool escape = can_paint(state) && escape_closes(), stops = escape && stroke_;
    // Without a stroke, Escape puts the brush away.
    if (escape && !stroke_) {
        commands::BrushSettings brush = state.brush;
        brush.tool = commands::BrushTool::none;
        context.emit(commands::ChangeBrush{brush});
    }
    // The state contains the finished stroke by now, so the tool's copy is no longer needed.
    const bool another = ground_ != state.ground || muscle_ != state.muscle || part_ != state.brush.part;
    if (handed_over_ || !can_paint(state) || (stroke_ && another) || stops) drop();
    // The view decides who gets the drag; here only its course is followed.
    const bool held = view.tool_held && can_paint(state), pressed = held && !was_held_;
    was_held_ = held;
    std::optional<Touch> touch;
    if (can_paint(state) && (view.hovered || held))
        if (const auto hit = commands::hit_on_body(state, scene, view.camera, view.size(), view.mouse)) {
            const Eigen::Vector3d rest = hit->place(*scene.surface, state.body->mesh.nodes);
            touch = Touch{*hit, hit->triangle / scene.surface->triangles_per_face(), rest,
                          commands::outward_at(*state.ground, rest)};
            // The normal comes from the body's own surface: that of a voxel face would have one of six directions.
        }
    if (touch) draw_ring(context, scene, view, *touch);
    if (pressed && touch) press(context, scene, *touch);
    if (!stroke_) return;
    // The mouse may leave the body during a stroke; the stroke then continues where it returns.
    if (held && touch) go_on(state, *touch);
    if (held) return;
    // The stroke ends: its paint stays visible until the command has changed the state.
    hand_over(context, *live_, "stroke");
    stroke_.reset();
    handed_over_ = true;
}

/// Draws the brush as a ring on the body. The ring is computed at rest, where the radius is measured, and deformed with
/// the triangle under the mouse.
void PaintTool::draw_ring(const PanelContext& context, const viewport::DrawnScene& scene,
                          const viewport::ViewportState& view, const Touch& touch) const {
    const commands::WorkbenchState& state = context.state;
    const Eigen::Matrix3d at_rest = frame_of(*scene.surface, state.body->mesh.nodes, touch.hit.triangle);
    const Eigen::Matrix3d deformation = frame_of(*scene.surface, scene.positions, touch.hit.triangle) *
                                        at_rest.inverse();
    const Eigen::Vector3d middle = touch.hit.place(*scene.surface, scene.positions);
    const Eigen::Vector3d u = touch.outward.unitOrthogonal(), v = touch.outward.cross(u);
    constexpr int points = 48;
    const auto ring = [&](double radius) {
        std::vector<ImVec2> pixels;
        for (int i = 0; i < points; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / points;
            const auto seen = viewport::project(
                view.camera, view.size(),
                middle + deformation * (radius * (std::cos(angle) * u + std::sin(angle) * v)));
            if (!seen) return;
            pixels.push_back({view.pixels.lowest.x + static_cast<float>(seen->x()),
                              view.pixels.lowest.y + static_cast<float>(seen->y())});
        }
        draw_outline(context, pixels);
    };
    // A fill has no radius; a small ring shows the element that is clicked. The second ring is where the soft edge
    // begins.
    if (state.brush.tool == commands::BrushTool::fill) return ring(0.25 * state.ground->places.edge_m);
    ring(state.brush.radius_m);
    if (const double falloff = used_brush(state).falloff; falloff > 0.0 && falloff < 1.0)
        ring((1.0 - falloff) * state.brush.radius_m);
}

}  // namespace myo::ui::panels
