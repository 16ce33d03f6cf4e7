#pragma once

#include "plot/plot.hpp"

namespace myo::ui::plot {

/// Width of a legend entry including its sample [pixels].
float legend_width(const chart::LegendEntry& entry, const platform::Theme& theme);

/// Draws an entry at the left edge of `box`, centred vertically.
///
/// @param hovered  the mouse is over the box: brighter text
/// @param pressed  the box was clicked in this frame: hides the curve, or shows it again if it was hidden
/// @param hidden  names of hidden curves; changed when `pressed`
void draw_legend_entry(ImDrawList& list, chart::LegendEntry entry, const platform::Rectangle& box, bool hovered,
                       bool pressed, const platform::Theme& theme, HiddenSeries& hidden);

}  // namespace myo::ui::plot
