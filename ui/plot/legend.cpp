#include "plot/legend.hpp"

#include "plot/draw_chart.hpp"

namespace myo::ui::plot {

float legend_width(const chart::LegendEntry& entry, const platform::Theme& theme) {
    return static_cast<float>(chart::legend_entry_width(entry, window_style(theme), window_text_width(theme)));
}

void draw_legend_entry(ImDrawList& list, chart::LegendEntry entry, const platform::Rectangle& box, bool hovered,
                       bool pressed, const platform::Theme& theme, HiddenSeries& hidden) {
    // A click removes the name from the hidden ones, or adds it.
    if (pressed && hidden.erase(entry.name) == 0) hidden.insert(entry.name);
    entry.hidden = hidden.count(entry.name) > 0;
    chart::Palette palette = chart_palette(theme);
    if (hovered) palette.legend = palette.text;
    const auto wide = [](float v) { return static_cast<double>(v); };
    chart::Drawing drawing;
    chart::draw_legend_entry(
        {std::move(entry), {wide(box.lowest.x), wide(box.lowest.y), wide(box.width()), wide(box.height())}},
        window_style(theme), palette, drawing);
    draw_chart(list, drawing, theme);
}

}  // namespace myo::ui::plot
