#include "chart/look.hpp"

namespace myo::chart {

std::map<std::string, int> slots_of_names(const Chart& chart) {
    std::map<std::string, int> slots;
    int next = 0;
    for (const Panel& panel : chart.panels)
        for (const Series& series : panel.series)
            if (series.colour == automatic_colour && !series.own_colour && !slots.contains(series.name))
                slots[series.name] = next++;
    return slots;
}

LegendEntry look_of(const Series& series, const std::map<std::string, int>& slots, const Palette& palette) {
    LegendEntry look{.name = series.name, .style = series.style, .hidden = series.hidden};
    look.interval = !series.ends.empty() && series.style != SeriesStyle::bars;
    if (series.own_colour) {
        look.colour = *series.own_colour;
        return look;
    }
    const int slot = series.colour == automatic_colour ? slots.at(series.name) : series.colour;
    look.colour = palette.slot(slot);
    // Beyond the palette colours repeat, and dots distinguish the second use.
    look.dotted = slot >= static_cast<int>(palette.series.size());
    return look;
}

}  // namespace myo::chart
