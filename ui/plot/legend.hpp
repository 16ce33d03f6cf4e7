#pragma once

#include "plot/plot.hpp"

namespace myo {

/// A name beside a sample of its curve.
struct LegendEntry {
    std::string name;
    ImVec4 color;
    bool dots = false;
};

float legend_width(const LegendEntry& entry, const Theme& theme);

/// Draws it with its left edge in the middle of the box's height; `pressed` shows or hides its curve.
void draw_legend_entry(ImDrawList& list, const LegendEntry& entry, const Rectangle& box, bool hovered, bool pressed, const Theme& theme, HiddenSeries& hidden);

}  // namespace myo
