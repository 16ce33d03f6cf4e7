#pragma once

#include <imgui.h>

#include "chart/drawing.hpp"
#include "platform/theme.hpp"

namespace myo::ui::plot {

/// Colour of the window as one of charts: eight bits per component, and the opacity.
chart::Colour chart_colour(const ImVec4& color);
/// Colour of charts as one of the window. Opacity is kept.
ImVec4 window_colour(const chart::Colour& colour);

/// Colours of charts in a theme.
chart::Palette chart_palette(const platform::Theme& theme);

/// Style of charts in the window: sizes of the theme.
chart::LayoutStyle window_style(const platform::Theme& theme);

/// Width of text in the font of labels [pixels], at the size that is asked for.
chart::TextWidth window_text_width(const platform::Theme& theme);

/// Draws marks into a draw list. The pixels of the drawing are those of the window.
void draw_chart(ImDrawList& list, const chart::Drawing& drawing, const platform::Theme& theme);

}  // namespace myo::ui::plot
