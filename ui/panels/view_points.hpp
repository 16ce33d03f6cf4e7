#pragma once

#include <imgui.h>

#include <Eigen/Core>

#include <optional>
#include <string>

#include "panels/panel.hpp"
#include "viewport/viewport.hpp"

namespace myo::ui::panels {

/// Where a point of the scene is in the window [pixels]; empty where it is behind the eye or not finite.
inline std::optional<ImVec2> window_pixel(const viewport::ViewportState& view, const Eigen::Vector3d& point_m) {
    if (!point_m.allFinite()) return std::nullopt;
    const auto seen = viewport::project(view.camera, view.size(), point_m);
    if (!seen) return std::nullopt;
    return ImVec2{view.pixels.lowest.x + static_cast<float>(seen->x()),
                  view.pixels.lowest.y + static_cast<float>(seen->y())};
}

/// How far from a marker a click still means it [pixels], at a scale of 1.
inline constexpr float marker_reach = 10.0f;

/// Whether Esc was pressed for the view rather than for a field or a popup.
inline bool escape_pressed() {
    return ImGui::IsKeyPressed(ImGuiKey_Escape, false) && !ImGui::GetIO().WantTextInput &&
           !ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId);
}

/// A note in a small box over the view, its text's upper left corner at `at` [pixels].
void draw_note(ImDrawList& list, const platform::Theme& theme, const ImVec2& at, const std::string& text);

/// What a tool waits for, in the middle below the view's buttons; marked as `item`.
void draw_hint(PanelContext& context, const viewport::ViewportState& view, const std::string& text,
               const std::string& item);

}  // namespace myo::ui::panels
