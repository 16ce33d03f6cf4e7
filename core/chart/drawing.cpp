#include "chart/drawing.hpp"

#include "chart/draw_parts.hpp"
#include "chart/look.hpp"

namespace myo::chart {
namespace {

/// One panel: shading, axes, clipped curves, references.
void draw_panel(const Chart& chart, std::size_t index, const Layout& layout, const Palette& palette,
                const std::map<std::string, int>& slots, Drawing& drawing) {
    const Panel& panel = chart.panels[index];
    const PlacedPanel& placed = layout.panels[index];
    if (!(palette.plot == palette.paper)) drawing.marks.push_back(Box{placed.area, palette.plot});
    draw_span_shades(panel, placed, layout, palette, drawing);
    draw_vertical_axis(panel.y, placed, layout, palette, drawing);
    draw_horizontal_axis(chart.x, placed.area, chart.x_labels && index + 1 == chart.panels.size(), layout, palette,
                         drawing);
    draw_span_labels(panel, placed, layout, palette, drawing);
    drawing.marks.push_back(Clip{placed.area});
    // Measured dots are drawn on top of computed lines: dots leave lines visible, lines would hide dots.
    for (const bool dots : {false, true})
        for (const Series& series : panel.series)
            if (!series.hidden && (series.style == SeriesStyle::dots) == dots)
                draw_series(series, look_of(series, slots, palette), placed, layout, palette, drawing);
    // References and their labels may reach over the edge of the area.
    drawing.marks.push_back(Clip{});
    draw_references(panel, placed, layout, palette, drawing);
}

}  // namespace

Drawing draw(const Chart& chart, const Layout& layout, const Palette& palette) {
    Drawing drawing{layout.frame, chart.title, {}};
    drawing.marks.push_back(Box{layout.frame, palette.paper});
    drawing.marks.push_back(Text{layout.title, chart.title, palette.text, layout.style.title, Anchor::start, true});
    for (const PlacedEntry& entry : layout.legend) draw_legend_entry(entry, layout.style, palette, drawing);
    const std::map<std::string, int> slots = slots_of_names(chart);
    for (std::size_t i = 0; i < chart.panels.size(); ++i) draw_panel(chart, i, layout, palette, slots, drawing);
    return drawing;
}

}  // namespace myo::chart
