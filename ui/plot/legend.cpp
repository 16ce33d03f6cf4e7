#include "plot/legend.hpp"

namespace myo::ui::plot {
namespace {

constexpr float sample_width = 14.0f, gap = 4.0f;  // [pixels] at scale 1

}  // namespace

float legend_width(const LegendEntry& entry, const platform::Theme& theme) {
    return (sample_width + gap) * theme.scale +
           theme.small->CalcTextSizeA(theme.small->FontSize, 1e6f, 0.0f, entry.name.c_str()).x;
}

void draw_legend_entry(ImDrawList& list, const LegendEntry& entry, const platform::Rectangle& box, bool hovered,
                       bool pressed, const platform::Theme& theme, HiddenSeries& hidden) {
    // A hidden curve keeps its entry, dimmed, so that a second click shows the curve again.
    if (pressed && hidden.erase(entry.name) == 0) hidden.insert(entry.name);
    const float alpha = hidden.count(entry.name) > 0 ? 0.35f : 1.0f;
    const float s = theme.scale, left = box.lowest.x, middle = box.center().y;
    if (entry.dots)
        list.AddCircleFilled({left + 0.5f * sample_width * s, middle}, 3.0f * s, platform::packed(entry.color, alpha),
                             12);
    else
        list.AddLine({left, middle}, {left + sample_width * s, middle}, platform::packed(entry.color, alpha), 2.0f * s);
    list.AddText(theme.small, theme.small->FontSize,
                 {left + (sample_width + gap) * s, middle - 0.5f * theme.small->FontSize},
                 platform::packed(hovered ? theme.text : theme.muted, alpha), entry.name.c_str());
}

}  // namespace myo::ui::plot
