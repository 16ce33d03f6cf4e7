#include "chart/layout.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/markup.hpp"
#include "chart/look.hpp"

namespace myo::chart {
namespace {

struct PlacePolicy {
    // Mean width of a letter in common sans-serif fonts, in font sizes.
    double glyph = 0.57;
    // Smallest width of a plot rectangle [px]; a narrower one shows nothing.
    double narrowest = 60.0;
    // Room between tick labels and the plot rectangle, and next to names of rows [px].
    double label_gap = 10.0, name_gap = 16.0;
    // Share of the width that names of rows may take.
    double names_share = 0.5;
    // Free room between neighbouring labels [px], and the height of a line of labels in font sizes.
    double between_labels = 6.0, label_line = 1.15;
    // Padding of a logarithmic x axis as a fraction of its decades.
    double logarithmic_padding = 0.03;
    // Height of a line of the legend [px].
    double legend_line = 18.0;
    // Height of names of categories; turned by 35 degrees they are cut off at 140 px.
    double names_height = 26.0, turned_margin = 22.0, turned_share = 0.6, turned_most = 140.0;
};
constexpr PlacePolicy place_policy;

/// Range of x over all panels, whose axis is common: samples, bars and intervals.
DataRange range_of_x(const Chart& chart) {
    DataRange range(chart.x);
    for (const Panel& panel : chart.panels) {
        for (const Series& series : panel.series) {
            for (const double x : series.x) range.add(x);
            for (const Range& ends : series.ends) range.add(ends.lowest), range.add(ends.highest);
        }
        // References of estimates must be visible, so they extend the range.
        if (!panel.y.categories.empty())
            for (const ReferenceLine& line : panel.vertical) range.add(line.value);
    }
    return range;
}

/// Range of the visible values including bands and reference lines.
DataRange range_of_y(const Panel& panel) {
    DataRange range(panel.y);
    for (const Series& series : panel.series) {
        if (series.hidden) continue;
        for (std::size_t i = 0; i < series.y.size(); ++i) {
            range.add(series.y[i]);
            if (i >= series.half_width.size()) continue;
            range.add(series.y[i] + series.half_width[i]);
            range.add(series.y[i] - series.half_width[i]);
        }
    }
    for (const ReferenceLine& line : panel.horizontal) range.add(line.value);
    return range;
}

/// Width of the widest label [px]; 0 without labels.
double widest_label(const std::vector<std::string>& labels, double size, const TextWidth& text_width) {
    double widest = 0.0;
    for (const std::string& label : labels) widest = std::max(widest, text_width(label, size));
    return widest;
}

/// Room left of the plot rectangles, the same for all panels, so that they align.
double left_room(const Chart& chart, const Layout& layout, const TextWidth& text_width) {
    double left = layout.style.left_margin;
    if (layout.style.compact) return left;
    for (std::size_t p = 0; p < chart.panels.size(); ++p) {
        const bool names = !chart.panels[p].y.categories.empty();
        const double widest = widest_label(layout.panels[p].y.ticks.labels,
                                           names ? layout.style.axis_title : layout.style.text, text_width);
        left = std::max(left, names ? std::min(std::max(widest + place_policy.name_gap, 2.0 * left),
                                               place_policy.names_share * chart.width_px)
                                    : widest + place_policy.label_gap);
    }
    return left;
}

/// How far compact charts move the label at an end of the axis inwards, so that it stays inside [px].
double moved_inwards(const Layout& layout, double left, double right) {
    if (!layout.style.compact || layout.x.ticks.values.empty()) return 0.0;
    const double first = layout.x.scale(layout.x.ticks.values.front()),
                 last = layout.x.scale(layout.x.ticks.values.back());
    return std::max(
        {0.0, left + 0.5 * layout.x_label_widths.front() - first, last + 0.5 * layout.x_label_widths.back() - right});
}

/// Ticks of x with their labels; names that are wider than their places are turned.
void place_x(const Chart& chart, double left, double width, const TextWidth& text_width, Layout& layout) {
    // Rows of estimates need room at both ends of x, as intervals end there; curves may touch the edges.
    const bool rows = !chart.panels.empty() && !chart.panels.front().y.categories.empty();
    const double padding = rows ? layout.style.y_padding
                                : (chart.x.logarithmic ? place_policy.logarithmic_padding : 0.0);
    layout.x = plan_axis(chart.x, range_of_x(chart), padding, left, left + width, layout.style.x_tick);
    Ticks& ticks = layout.x.ticks;
    if (layout.style.compact)
        for (std::string& label : ticks.labels) {
            if (!ticks.factor.empty() && label != "0") label += "·" + ticks.factor;
            if (!chart.x.unit.empty()) label += " " + chart.x.unit;
        }
    for (const std::string& label : ticks.labels) layout.x_label_widths.push_back(text_width(label, layout.style.text));
    const double widest = widest_label(ticks.labels, layout.style.text, text_width);
    if (chart.x.categories.empty())
        thin_labels(layout.x, widest + place_policy.between_labels + moved_inwards(layout, left, left + width));
    else
        layout.turned = widest > width / static_cast<double>(chart.x.categories.size()) - place_policy.label_gap;
}

/// One entry per name.
std::vector<LegendEntry> entries_of(const Chart& chart, const Palette& palette) {
    const std::map<std::string, int> slots = slots_of_names(chart);
    std::vector<LegendEntry> entries;
    for (const Panel& panel : chart.panels)
        for (const Series& series : panel.series) {
            const bool listed = std::any_of(entries.begin(), entries.end(),
                                            [&](const LegendEntry& e) { return e.name == series.name; });
            if (!series.name.empty() && !listed) entries.push_back(look_of(series, slots, palette));
        }
    return entries;
}

/// Entries from left to right in lines below each other. Returns the height used.
double place_legend(const std::vector<LegendEntry>& entries, double left, double top, double width,
                    const TextWidth& text_width, Layout& layout) {
    if (entries.empty()) return 0.0;
    double x = left, y = top + 3.0;
    for (const LegendEntry& entry : entries) {
        const double needed = legend_entry_width(entry, layout.style, text_width);
        // Wrap, but never leave a line empty.
        if (x > left && x + needed > left + width) {
            x = left;
            y += place_policy.legend_line;
        }
        layout.legend.push_back({entry, {x, y, needed, place_policy.legend_line - 4.0}});
        x += needed + layout.style.legend_gap;
    }
    return y - top + place_policy.legend_line - 1.0;
}

/// Entries from right to left in the line of the title: the first ones are left out if there is no room for all.
void place_beside_title(const std::vector<LegendEntry>& entries, const Rectangle& line, double title_end,
                        const TextWidth& text_width, Layout& layout) {
    double right = line.right();
    for (std::size_t i = entries.size(); i-- > 0;) {
        const double width = legend_entry_width(entries[i], layout.style, text_width);
        if (right - width < title_end) break;
        layout.legend.insert(layout.legend.begin(), {entries[i], {right - width, line.top, width, line.height}});
        right -= width + layout.style.legend_gap;
    }
}

/// Moves the panels below each other and returns the lower end of the chart.
double place_panels(const Chart& chart, double left, double top, double width, Layout& layout) {
    const LayoutStyle& style = layout.style;
    for (std::size_t i = 0; i < chart.panels.size(); ++i) {
        PlacedPanel& panel = layout.panels[i];
        // Names of rows need no title.
        const bool heading = style.compact
                                 ? !layout.legend.empty() || !axis_title(chart.panels[i].y, panel.y.ticks).empty()
                                 : chart.panels[i].y.categories.empty();
        panel.area = {left, top + (heading ? style.panel_heading : style.bare_margin), width,
                      chart.panels[i].height_px};
        // The scale was planned from 0 at the upper edge of the panel, before its place was known.
        panel.y.scale.from_px += panel.area.top;
        panel.y.scale.to_px += panel.area.top;
        // Only the last panel needs room for the labels of the x axis.
        top = panel.area.bottom() + style.panel_gap;
    }
    return top - style.panel_gap;
}

/// Height below the last panel.
double room_below(const Chart& chart, const Layout& layout, const TextWidth& text_width) {
    if (!chart.x_labels) return layout.style.bare_margin;
    if (chart.x.categories.empty()) return layout.style.x_axis_height;
    const double widest = widest_label(chart.x.categories, layout.style.text, text_width);
    return layout.turned
               ? place_policy.turned_margin + std::min(place_policy.turned_share * widest, place_policy.turned_most)
               : place_policy.names_height;
}

/// Asserts that the arrays of each series have one length, and that bars have ends.
void check_lengths([[maybe_unused]] const Chart& chart) {
    for ([[maybe_unused]] const Panel& panel : chart.panels)
        for ([[maybe_unused]] const Series& series : panel.series)
            assert(series.x.size() == series.y.size() &&
                   (series.half_width.empty() || series.half_width.size() == series.y.size()) &&
                   (series.ends.empty() ? series.style != SeriesStyle::bars || series.x.empty()
                                        : series.ends.size() == series.y.size()));
}

}  // namespace

double estimated_text_width(std::string_view text, double size) {
    return place_policy.glyph * size * character_count(text);
}

LayoutStyle compact_style(double text_px, double scale) {
    LayoutStyle style;
    style.text = style.axis_title = style.legend = text_px;
    style.line *= scale;
    style.dot = 3.4 * scale;
    style.left_margin = 52.0 * scale;
    style.right_margin = 8.0 * scale;
    style.title_height = style.gap = 0.0;
    style.panel_heading = text_px + 8.0 * scale;
    style.x_axis_height = text_px + 6.0 * scale;
    style.bare_margin = 4.0 * scale;
    style.x_tick = 64.0 * scale;
    style.y_tick = 26.0 * scale;
    style.y_padding = 0.08;
    style.legend_sample = 14.0 * scale;
    style.legend_gap = 10.0 * scale;
    style.fewest_entries = 1;
    style.vertical_grid = style.compact = true;
    return style;
}

double added_height(const LayoutStyle& style, bool heading, bool x_labels) {
    return style.gap + (heading ? style.panel_heading : style.bare_margin) +
           (x_labels ? style.x_axis_height : style.bare_margin);
}

double legend_entry_width(const LegendEntry& entry, const LayoutStyle& style, const TextWidth& text_width) {
    return style.legend_sample + 0.5 * style.legend + text_width(entry.name, style.legend);
}

Layout lay_out(const Chart& chart, const LayoutStyle& style, const Palette& palette, const TextWidth& text_width,
               const Point& origin) {
    check_lengths(chart);
    Layout layout;
    layout.style = style;
    for (const Panel& panel : chart.panels) {
        const bool rows = !panel.y.categories.empty();
        layout.panels.push_back(
            {{}, plan_axis(panel.y, range_of_y(panel), style.y_padding, panel.height_px, 0.0, style.y_tick)});
        if (!rows) thin_labels(layout.panels.back().y, place_policy.label_line * style.text);
    }
    // The order follows what is known: labels of y fix the left margin, this the width of x, and both the legend.
    const double room = left_room(chart, layout, text_width);
    const double left = origin.x + room;
    const double width = std::max(style.compact ? 0.0 : place_policy.narrowest,
                                  chart.width_px - room - style.right_margin);
    place_x(chart, left, width, text_width, layout);

    double top = origin.y + (chart.title.empty() ? 0.0 : style.title_height);
    std::vector<LegendEntry> entries;
    if (chart.legend) entries = entries_of(chart, palette);
    if (entries.size() < style.fewest_entries) entries.clear();
    if (style.compact && !chart.panels.empty()) {
        const std::string title = axis_title(chart.panels.front().y, layout.panels.front().y.ticks);
        const double title_end = origin.x + style.right_margin +
                                 (title.empty() ? 0.0 : text_width(title, style.axis_title) + style.legend_gap);
        place_beside_title(entries, {left, top, width, style.panel_heading}, title_end, text_width, layout);
    } else {
        top += place_legend(entries, left, top + style.gap, width, text_width, layout);
    }
    layout.title = {chart.panels.size() == 1 && !chart.panels.front().y.categories.empty() ? origin.x + 8.0 : left,
                    origin.y + 15.0};
    const double bottom = place_panels(chart, left, top + style.gap, width, layout) +
                          room_below(chart, layout, text_width);
    layout.frame = {origin.x, origin.y, room + width + style.right_margin, bottom - origin.y};
    return layout;
}

}  // namespace myo::chart
