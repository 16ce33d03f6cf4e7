#include "viewport/viewport.hpp"

#include <imgui.h>

#include <array>
#include <cmath>

#include "platform/fonts.hpp"
#include "viewport/view_overlay.hpp"

namespace myo::ui::viewport {
namespace {

/// Camera control with the mouse. Fills the state's fields for this frame.
void react_to_mouse(ViewportState& state, bool hovered, bool active, const ToolTakes& takes) {
    const ImGuiIO& io = ImGui::GetIO();
    state.hovered = hovered;
    state.mouse = {static_cast<double>(io.MousePos.x - state.pixels.lowest.x),
                   static_cast<double>(io.MousePos.y - state.pixels.lowest.y)};
    // A tool claims the drag when the button goes down; moving off the body later does not return the drag to the
    // camera.
    if (ImGui::IsItemActivated() && ImGui::IsMouseDown(ImGuiMouseButton_Left))
        state.tool_held = takes && takes(state.mouse);
    state.tool_held = state.tool_held && active && ImGui::IsMouseDown(ImGuiMouseButton_Left);
    // A press and release in place is a click; a longer movement is a drag of the camera.
    const bool in_place = io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] <
                          io.MouseDragThreshold * io.MouseDragThreshold;
    state.clicked = ImGui::IsItemDeactivated() && hovered && ImGui::IsMouseReleased(ImGuiMouseButton_Left) && in_place;
    const ViewSize size = state.size();
    const double dx = static_cast<double>(io.MouseDelta.x);
    const double dy = static_cast<double>(io.MouseDelta.y);
    const Camera before = state.camera;
    if (active && !state.tool_held && (dx != 0.0 || dy != 0.0)) {
        const bool turns = ImGui::IsMouseDown(ImGuiMouseButton_Left) && !io.KeyShift;
        state.camera = turns ? orbit(state.camera, dx, dy) : pan(state.camera, size, dx, dy);
    }
    // A factor per notch, so that the same number of notches back restores the distance.
    if (hovered && io.MouseWheel != 0.0f) {
        state.camera = zoom(state.camera, size, std::pow(0.87, static_cast<double>(io.MouseWheel)), state.mouse);
    }
    state.moving = !(state.camera == before);
    state.untouched = state.untouched && !state.moving;
}

/// Buttons of the standard directions of view.
struct ViewButton {
    const char* label;
    const char* name;
    StandardView view;
    const char* tip;
};
constexpr std::array<ViewButton, 4> view_buttons{
    {{"3D", "view/oblique", StandardView::oblique, "Oblique view (0)"},
     {"X", "view/x", StandardView::from_x, "View along the x axis (1); again: from the other side"},
     {"Y", "view/y", StandardView::from_y, "View along the y axis (2); again: from the other side"},
     {"Z", "view/z", StandardView::from_z, "View along the z axis, from above (3); again: from below"}}};

/// Buttons in the upper left corner of the view. They lie over the invisible button that receives the mouse.
void draw_buttons(const platform::Theme& theme, platform::ItemRectangles& items, ViewportState& state) {
    const float s = theme.scale;
    ImGui::SetCursorScreenPos({state.pixels.lowest.x + 12.0f * s, state.pixels.lowest.y + 12.0f * s});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(4.0f * s, 4.0f * s));
    const auto tip = [](const char* text) {
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text);
    };
    if (ImGui::Button(platform::icon::expand)) {
        state.zoom_to_data_requested = true;
        state.untouched = true;
    }
    items.mark("view/fit");
    tip("Show the whole body (F)");
    for (const ViewButton& button : view_buttons) {
        ImGui::SameLine();
        if (ImGui::Button(button.label)) {
            state.camera = turn_to_or_round(state.camera, button.view);
            state.zoom_to_data_requested = true;
        }
        items.mark(button.name);
        tip(button.tip);
    }
    ImGui::PopStyleVar();
}

}  // namespace

void draw_viewport(const DrawnScene& scene, const platform::Theme& theme, platform::ItemRectangles& items,
                   ViewportState& state, bool labels, const ToolTakes& takes) {
    const ImVec2 lowest = ImGui::GetWindowPos();
    const ImVec2 extent = ImGui::GetWindowSize();
    state.pixels = {{std::floor(lowest.x), std::floor(lowest.y)},
                    {std::floor(lowest.x + extent.x), std::floor(lowest.y + extent.y)}};
    // Valid for one frame only; cleared also if the view is too small to be drawn.
    state.moving = state.hovered = state.clicked = false;
    if (state.size().width < 2 || state.size().height < 2) return;
    items.add("view", state.pixels);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool nothing = !scene.surface && scene.markers.empty();
    if (nothing) return;
    // The button covers the whole view. Overlap lets the view buttons and options take the mouse before it.
    ImGui::SetCursorScreenPos(state.pixels.lowest);
    ImGui::SetItemAllowOverlap();
    ImGui::InvisibleButton(
        "view", extent,
        ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
    ImGui::SetItemAllowOverlap();
    react_to_mouse(state, ImGui::IsItemHovered(), ImGui::IsItemActive(), takes);
    draw_buttons(theme, items, state);
    if (state.zoom_to_data_requested) {
        state.camera = fit(state.camera, state.size(), scene.reach);
        state.zoom_to_data_requested = false;
    }
    draw_view_overlay(list, state.pixels, state.camera, scene, theme, labels);
}

}  // namespace myo::ui::viewport
