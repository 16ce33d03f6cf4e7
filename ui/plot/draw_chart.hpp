#pragma once

#include <imgui.h>

#include "chart/drawing.hpp"
#include "platform/theme.hpp"

namespace myo::ui::plot {

/// Conversions between the colours of the window and those of charts. Opacity is kept.
chart::Colour chart_colour(const ImVec4& color);
ImVec4 window_colour(const chart::Colour& colour);

/// Colours of charts in a theme.
chart::Palette chart_palette(const platform::Theme& theme);

/// Style of charts in the window: sizes of the theme.
chart::LayoutStyle window_style(const platform::Theme& theme);

/// Width of text in the font of labels.
chart::TextWidth window_text_width(const platform::Theme& theme);

/// Draws marks into a draw list. The pixels of the drawing are those of the window.
void draw_chart(ImDrawList& list, const chart::Drawing& drawing, const platform::Theme& theme);

}  // namespace myo::ui::plot
