#include "viewport/scene.hpp"

namespace myo::ui::viewport {

ViewColors view_colors(const platform::Theme& theme) {
    ViewColors colors;
    colors.top = color_of(theme.view_top);
    colors.bottom = color_of(theme.view_bottom);
    colors.grid = color_of(theme.grid, 0.8f);
    colors.body = color_of(theme.body);
    colors.edge = Color(0.05f, 0.07f, 0.10f, theme.edge_strength);
    return colors;
}

}  // namespace myo::ui::viewport
