#include "panels/view_points.hpp"

namespace myo::ui::panels {
namespace {

/// Size of a text in the small font [pixels].
ImVec2 extent_of(const platform::Theme& theme, const std::string& text) {
    return theme.small->CalcTextSizeA(theme.small->FontSize, 1e6f, 0.0f, text.c_str());
}

}  // namespace

void draw_note(ImDrawList& list, const platform::Theme& theme, const ImVec2& at, const std::string& text) {
    const float s = theme.scale;
    const ImVec2 extent = extent_of(theme, text);
    // Nearly opaque, so that the text is readable over any scene.
    list.AddRectFilled({at.x - 5.0f * s, at.y - 3.0f * s}, {at.x + extent.x + 5.0f * s, at.y + extent.y + 3.0f * s},
                       platform::packed(theme.popup, 0.92f), 4.0f * s);
    list.AddText(theme.small, theme.small->FontSize, at, platform::packed(theme.text), text.c_str());
}

void draw_hint(PanelContext& context, const viewport::ViewportState& view, const std::string& text,
               const std::string& item) {
    const ImVec2 extent = extent_of(context.theme, text);
    const ImVec2 at{0.5f * (view.pixels.lowest.x + view.pixels.highest.x - extent.x),
                    view.pixels.lowest.y + 56.0f * context.theme.scale};
    draw_note(*ImGui::GetWindowDrawList(), context.theme, at, text);
    context.items.add(item, {at, {at.x + extent.x, at.y + extent.y}});
}

}  // namespace myo::ui::panels
