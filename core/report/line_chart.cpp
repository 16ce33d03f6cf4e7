#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>

#include "report/decimate.hpp"
#include "report/frame.hpp"
#include "report/markup.hpp"

namespace myo::report {
namespace {

struct LineChartLayout {
    double right_margin = 22.0;
    double title_of_panel = 24.0;
};
constexpr LineChartLayout line_chart_layout;

/// Appearance of a series.
struct Look {
    std::string_view colour;
    bool line = true;
    bool dots = false;
    std::string dash;  // SVG dash pattern; empty: solid
};

// Slots by name: equal names have equal colours in all panels.
std::map<std::string, int> slots_of_names(const LineChart& chart) {
    std::map<std::string, int> slots;
    int next = 0;
    for (const ChartPanel& panel : chart.panels)
        for (const Series& series : panel.series)
            if (series.colour == automatic_colour && !slots.contains(series.name)) slots[series.name] = next++;
    return slots;
}

/// Style of a series. Names beyond the palette repeat colours and are dashed instead.
Look look_of(const Series& series, const std::map<std::string, int>& slots) {
    const int slot = series.colour == automatic_colour ? slots.at(series.name) : series.colour;
    Look look{slot_colour(slot),
              series.style != SeriesStyle::dots,
              series.style == SeriesStyle::dots || series.style == SeriesStyle::line_and_dots,
              {}};
    if (series.style == SeriesStyle::dashed)
        // A dashed series keeps its pattern, also beyond the palette.
        look.dash = "6 4";
    else if (slot >= static_cast<int>(series_palette.size()))
        look.dash = "2 3";
    return look;
}

// A dot is a stroke of zero length with round ends: the shortest SVG for many dots.
// `data`: SVG path commands.
std::string dots_path(const std::string& data, const Look& look, double diameter) {
    if (data.empty()) return {};
    return "<path d=\"" + data + "\" fill=\"none\" stroke=\"" + std::string(look.colour) + "\" stroke-width=\"" +
           pixel(diameter) + "\" stroke-linecap=\"round\"/>\n";
}

std::string line_path(const std::string& data, const Look& look) {
    if (data.empty()) return {};
    std::string out = "<path d=\"" + data + "\" fill=\"none\" stroke=\"" + std::string(look.colour) +
                      "\" stroke-width=\"1.6\" stroke-linejoin=\"round\"";
    if (!look.dash.empty()) out += " stroke-dasharray=\"" + look.dash + "\"";
    return out + "/>\n";
}

/// Curve with gaps: one path for lines and one for dots.
std::string draw_curve(const Polyline& curve, const Look& look) {
    std::string lines, dots;
    const auto drawable = [&](std::size_t i) { return std::isfinite(curve.x[i]) && std::isfinite(curve.y[i]); };
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        if (!drawable(i)) continue;
        const std::string point = pixel(curve.x[i]) + " " + pixel(curve.y[i]);
        const bool starts = i == 0 || !drawable(i - 1);
        const bool ends = i + 1 == curve.x.size() || !drawable(i + 1);
        // An isolated sample between two gaps would be an invisible line: draw a dot.
        if (look.dots || (starts && ends)) dots += "M" + point + "h0";
        if (look.line && !(starts && ends)) lines += (starts ? "M" : "L") + point;
    }
    return line_path(lines, look) + dots_path(dots, look, look.dots ? 4.2 : 2.4);
}

// Each part of the band between gaps is a closed outline: forwards along the upper edge, back along the lower one.
std::string draw_band(const Series& series, const Scale& x, const Scale& y, const Look& look) {
    std::string data, back;
    const std::size_t count = std::min({series.x.size(), series.y.size(), series.half_width.size()});
    for (std::size_t i = 0; i <= count; ++i) {
        // One index beyond the end closes the last run.
        const double px = i < count ? x(series.x[i]) : NAN;
        const double upper = i < count ? y(series.y[i] + series.half_width[i]) : NAN;
        const double lower = i < count ? y(series.y[i] - series.half_width[i]) : NAN;
        if (std::isfinite(px) && std::isfinite(upper) && std::isfinite(lower)) {
            data += (back.empty() ? "M" : "L") + pixel(px) + " " + pixel(upper);
            back = "L" + pixel(px) + " " + pixel(lower) + back;
        } else if (!back.empty()) {
            data += back + "Z";
            back.clear();
        }
    }
    if (data.empty()) return {};
    return "<path d=\"" + data + "\" fill=\"" + std::string(look.colour) + "\" fill-opacity=\"0.15\"/>\n";
}

/// Scales a series to pixels and draws its band and curve.
std::string draw_series(const Series& series, const Scale& x, const Scale& y, const Look& look) {
    Polyline curve;
    const std::size_t count = std::min(series.x.size(), series.y.size());
    curve.x.reserve(count);
    curve.y.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        curve.x.push_back(x(series.x[i]));
        curve.y.push_back(y(series.y[i]));
    }
    return draw_band(series, x, y, look) + draw_curve(decimate(curve), look);
}

std::string draw_horizontal_references(const ChartPanel& panel, const Scale& scale, const Rectangle& area) {
    std::string out;
    for (const ReferenceLine& line : panel.horizontal) {
        const double y = scale(line.value);
        if (!std::isfinite(y) || y < area.top - 0.5 || y > area.bottom() + 0.5) continue;
        out += svg_line(area.left, y, area.right(), y, ink::quiet, 1.0, "4 3");
        out += svg_text(area.right() - 4.0, y - 4.0 < area.top + 8.0 ? y + 12.0 : y - 4.0, line.label,
                        {.anchor = Anchor::end, .colour = ink::text, .halo = true});
    }
    return out;
}

/// Spans in two passes: first the shading, below the grid, then the labels (`words`).
std::string draw_spans(const ChartPanel& panel, const Scale& scale, const Rectangle& area, bool words) {
    std::string out;
    for (const Span& span : panel.spans) {
        const double from = std::clamp(scale(span.from), area.left, area.right());
        const double to = std::clamp(scale(span.to), area.left, area.right());
        if (!(to > from)) continue;
        // Labels are drawn after the grid, which would cross them.
        if (words)
            out += svg_text(from + 5.0, area.bottom() - 6.0, span.label, {.halo = true});
        else
            out += svg_box({from, area.top, to - from, area.height}, ink::shade);
    }
    return out;
}

/// One entry per series name.
std::vector<LegendEntry> legend_of(const LineChart& chart, const std::map<std::string, int>& slots) {
    std::vector<LegendEntry> entries;
    for (const ChartPanel& panel : chart.panels)
        for (const Series& series : panel.series) {
            const bool listed = std::any_of(entries.begin(), entries.end(),
                                            [&](const LegendEntry& e) { return e.name == series.name; });
            if (series.name.empty() || listed) continue;
            const Look look = look_of(series, slots);
            entries.push_back({series.name, (look.line ? line_path("M0 0L22 0", look) : std::string{}) +
                                                (look.dots ? dots_path("M11 0h0", look, 4.2) : std::string{})});
        }
    return entries;
}

/// Common range of x over all panels.
DataRange range_of_x(const LineChart& chart) {
    DataRange range(chart.x);
    for (const ChartPanel& panel : chart.panels)
        for (const Series& series : panel.series)
            for (const double value : series.x) range.add(value);
    return range;
}

/// Range of the values including bands and reference lines.
DataRange range_of_y(const ChartPanel& panel) {
    DataRange range(panel.y);
    for (const Series& series : panel.series)
        for (std::size_t i = 0; i < series.y.size(); ++i) {
            range.add(series.y[i]);
            if (i >= series.half_width.size()) continue;
            range.add(series.y[i] + series.half_width[i]);
            range.add(series.y[i] - series.half_width[i]);
        }
    for (const ReferenceLine& line : panel.horizontal) range.add(line.value);
    return range;
}

/// One panel: shading, axes, clipped curves, reference lines. Only the last panel has labels at the x axis.
std::string draw_panel(const LineChart& chart, const ChartPanel& panel, const Rectangle& area, const PlannedAxis& x,
                       const PlannedAxis& y, const std::map<std::string, int>& slots, bool last) {
    std::string out = draw_spans(panel, x.scale, area, false) + draw_vertical_axis(panel.y, y, area) +
                      draw_horizontal_axis(chart.x, x, area, last) + draw_spans(panel, x.scale, area, true);
    // A nested document clips its content without an id, which could clash with other figures of the page.
    out += "<svg x=\"" + pixel(area.left) + "\" y=\"" + pixel(area.top) + "\" width=\"" + pixel(area.width) +
           "\" height=\"" + pixel(area.height) + "\" viewBox=\"" + pixel(area.left) + " " + pixel(area.top) + " " +
           pixel(area.width) + " " + pixel(area.height) + "\" overflow=\"hidden\">\n";
    // Measured dots are drawn on top of computed lines: dots leave lines visible, lines would hide dots.
    for (const bool dots : {false, true})
        for (const Series& series : panel.series)
            if ((series.style == SeriesStyle::dots) == dots)
                out += draw_series(series, x.scale, y.scale, look_of(series, slots));
    out += "</svg>\n";
    return out + draw_horizontal_references(panel, y.scale, area) +
           draw_vertical_references(panel.vertical, x.scale, area);
}

}  // namespace

std::string svg(const LineChart& chart) {
    for ([[maybe_unused]] const ChartPanel& panel : chart.panels)
        for ([[maybe_unused]] const Series& series : panel.series)
            assert(series.x.size() == series.y.size() &&
                   (series.half_width.empty() || series.half_width.size() == series.y.size()));
    // A common left margin aligns the panels: the widest labels of all y axes.
    double left = 30.0;
    std::vector<PlannedAxis> y_axes;
    for (const ChartPanel& panel : chart.panels) {
        y_axes.push_back(plan_axis(panel.y, range_of_y(panel), 0.05, panel.height_px, 0.0));
        left = std::max(left, label_room(y_axes.back().ticks));
    }
    const double width = std::max(60.0, chart.width_px - left - line_chart_layout.right_margin);
    const PlannedAxis x = plan_axis(chart.x, range_of_x(chart), chart.x.logarithmic ? 0.03 : 0.0, left, left + width);
    const std::map<std::string, int> slots = slots_of_names(chart);

    double title_height = 0.0, legend_height = 0.0;
    std::string body = draw_title(chart.title, left, title_height);
    const std::vector<LegendEntry> entries = legend_of(chart, slots);
    // A single curve needs no legend: the axis names it.
    if (entries.size() > 1) body += draw_legend(entries, left, title_height + 6.0, width, legend_height);
    double top = title_height + legend_height + 6.0;
    for (std::size_t i = 0; i < chart.panels.size(); ++i) {
        const Rectangle area{left, top + line_chart_layout.title_of_panel, width, chart.panels[i].height_px};
        PlannedAxis y = y_axes[i];
        y.scale.from_px += area.top;
        y.scale.to_px += area.top;
        const bool last = i + 1 == chart.panels.size();
        body += draw_panel(chart, chart.panels[i], area, x, y, slots, last);
        // Only the last panel needs room for the labels of the x axis.
        top = area.bottom() + (last ? frame_layout.horizontal_axis_height : 8.0);
    }
    return open_svg(left + width + line_chart_layout.right_margin, top, chart.title) + body + "</svg>\n";
}

}  // namespace myo::report
