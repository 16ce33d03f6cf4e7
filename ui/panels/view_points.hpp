#pragma once

#include <imgui.h>

#include <Eigen/Core>

#include <optional>
#include <string>

#include "panels/panel.hpp"
#include "viewport/viewport.hpp"

namespace myo::ui::panels {

/// Pixel of a point of the scene in the window. Empty if the point lies behind the eye or is not finite.
inline std::optional<ImVec2> window_pixel(const viewport::ViewportState& view, const Eigen::Vector3d& point_m) {
    if (!point_m.allFinite()) return std::nullopt;
    const auto seen = viewport::project(view.camera, view.size(), point_m);
    if (!seen) return std::nullopt;
    return ImVec2{view.pixels.lowest.x + static_cast<float>(seen->x()),
                  view.pixels.lowest.y + static_cast<float>(seen->y())};
}

/// Distance from a marker within which a click selects it [pixels at scale 1].
inline constexpr float marker_reach = 10.0f;

/// Draws a text in a small box over the view. `at`: upper left corner of the text [pixels in the window].
void draw_note(ImDrawList& list, const platform::Theme& theme, const ImVec2& at, const std::string& text);

/// Draws what a tool waits for, centred below the view's buttons.
///
/// @param item  item name for tests
void draw_hint(PanelContext& context, const viewport::ViewportState& view, const std::string& text,
               const std::string& item);

}  // namespace myo::ui::panels
