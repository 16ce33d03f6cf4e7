#pragma once

#include "plot/plot.hpp"

namespace myo::ui::plot {

/// A name beside a sample of its curve.
struct LegendEntry {
    std::string name;
    ImVec4 color;
    bool dots = false;
};

float legend_width(const LegendEntry& entry, const platform::Theme& theme);

/// Draws it with its left edge in the middle of the box's height; `pressed` shows or hides its curve.
void draw_legend_entry(ImDrawList& list, const LegendEntry& entry, const platform::Rectangle& box, bool hovered,
                       bool pressed, const platform::Theme& theme, HiddenSeries& hidden);

}  // namespace myo::ui::plot
