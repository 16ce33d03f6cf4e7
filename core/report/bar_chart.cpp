#include <algorithm>
#include <cassert>
#include <cmath>

#include "report/frame.hpp"
#include "report/markup.hpp"

namespace myo::report {
namespace {

struct BarChartLayout {
    /// Right margin for the last tick label, and space above a panel for its axis title [px].
    double right_margin = 22.0;
    double title_of_panel = 24.0;
};
constexpr BarChartLayout bar_chart_layout;

// Bar between zero and the value, in either order; empty if the value cannot be drawn.
std::string draw_bar(const PlannedAxis& y, const Rectangle& area, double left, double width, double value,
                     std::string_view colour) {
    // A logarithmic axis has no zero: bars start at its lower end.
    const double base = y.scale(y.scale.logarithmic ? y.scale.lowest
                                                    : std::clamp(0.0, y.scale.lowest, y.scale.highest));
    const double end = std::clamp(y.scale(value), area.top, area.bottom());
    if (!std::isfinite(y.scale(value))) return {};
    return svg_box({left, std::min(base, end), width, std::abs(end - base)}, colour, width > 8.0 ? 1.5 : 0.0);
}

// Category names below the axis; long ones are rotated so that they do not overlap.
std::string draw_categories(const std::vector<std::string>& names, const Rectangle& area, bool turned) {
    std::string out = svg_line(area.left, area.bottom(), area.right(), area.bottom(), ink::axis, 1.0);
    const double slot = area.width / std::max<double>(1.0, static_cast<double>(names.size()));
    for (std::size_t i = 0; i < names.size(); ++i) {
        const double x = area.left + (static_cast<double>(i) + 0.5) * slot;
        if (turned)
            out += "<g transform=\"translate(" + pixel(x + 4.0) + " " + pixel(area.bottom() + 14.0) +
                   ") rotate(-35)\">" + svg_text(0, 0, names[i], {.anchor = Anchor::end}) + "</g>\n";
        else
            out += svg_text(x, area.bottom() + 16.0, names[i], {.anchor = Anchor::middle});
    }
    return out;
}

/// No legend for a single group.
std::vector<LegendEntry> legend_of(const BarChart& chart) {
    std::vector<LegendEntry> entries;
    if (chart.groups.size() < 2) return entries;
    for (std::size_t g = 0; g < chart.groups.size(); ++g)
        entries.push_back({chart.groups[g].name, svg_box({6, -6, 12, 12}, slot_colour(static_cast<int>(g)), 1.5)});
    return entries;
}

}  // namespace

std::string svg(const BarChart& chart) {
    Axis axis = chart.y;
    // Bars encode values by length: the axis must contain zero.
    axis.include_zero = !axis.logarithmic;
    DataRange range(axis);
    for (const BarGroup& group : chart.groups) {
        assert(group.values.size() == chart.categories.size());
        for (const double value : group.values) range.add(value);
    }
    // The left margin depends on the tick labels, so the axis is planned for the height first and shifted later.
    PlannedAxis y = plan_axis(axis, range, 0.06, chart.height_px, 0.0);
    const double left = std::max(30.0, label_room(y.ticks));
    const double width = std::max(60.0, chart.width_px - left - bar_chart_layout.right_margin);
    const double count = std::max<double>(1.0, static_cast<double>(chart.categories.size()));
    double widest = 0.0;
    for (const std::string& name : chart.categories) widest = std::max(widest, text_width(name));
    // Rotate all labels if the widest one is wider than its category.
    const bool turned = widest > width / count - 8.0;

    double title_height = 0.0, legend_height = 0.0;
    std::string body = draw_title(chart.title, left, title_height);
    body += draw_legend(legend_of(chart), left, title_height + 6.0, width, legend_height);
    const Rectangle area{left, title_height + legend_height + 6.0 + bar_chart_layout.title_of_panel, width,
                         chart.height_px};
    y.scale.from_px += area.top;
    y.scale.to_px += area.top;
    body += draw_vertical_axis(axis, y, area);
    const double slot = width / count, groups = std::max<double>(1.0, static_cast<double>(chart.groups.size()));
    // 72 % of a category are bars, the rest separates categories; few bars do not become wider than 56 px.
    const double bar = std::min(0.72 * slot / groups, 56.0);
    for (std::size_t g = 0; g < chart.groups.size(); ++g)
        for (std::size_t i = 0; i < std::min(chart.groups[g].values.size(), chart.categories.size()); ++i)
            body += draw_bar(
                y, area, left + (static_cast<double>(i) + 0.5) * slot + (static_cast<double>(g) - 0.5 * groups) * bar,
                bar - 1.0, chart.groups[g].values[i], slot_colour(static_cast<int>(g)));
    body += draw_categories(chart.categories, area, turned);
    // Height of the category labels; rotated ones are cut off at 140 px.
    const double below = turned ? 22.0 + std::min(0.6 * widest, 140.0) : 26.0;
    return open_svg(left + width + bar_chart_layout.right_margin, area.bottom() + below, chart.title) + body +
           "</svg>\n";
}

std::string svg(const Histogram& histogram) {
    assert(histogram.edges.empty() ? histogram.counts.empty() : histogram.edges.size() == histogram.counts.size() + 1);
    const Axis count_axis{.label = histogram.count_label, .unit = {}, .include_zero = true};
    DataRange counts(count_axis), values(histogram.x);
    for (const double count : histogram.counts) counts.add(count);
    for (const double edge : histogram.edges) values.add(edge);
    PlannedAxis y = plan_axis(count_axis, counts, 0.06, histogram.height_px, 0.0);
    const double left = std::max(30.0, label_room(y.ticks));
    const double width = std::max(60.0, histogram.width_px - left - bar_chart_layout.right_margin);
    const PlannedAxis x = plan_axis(histogram.x, values, 0.0, left, left + width);

    double title_height = 0.0;
    std::string body = draw_title(histogram.title, left, title_height);
    const Rectangle area{left, title_height + 6.0 + bar_chart_layout.title_of_panel, width, histogram.height_px};
    y.scale.from_px += area.top;
    y.scale.to_px += area.top;
    body += draw_vertical_axis(count_axis, y, area);
    for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
        const double from = std::clamp(x.scale(histogram.edges[i]), area.left, area.right());
        const double to = std::clamp(x.scale(histogram.edges[i + 1]), area.left, area.right());
        // Outside the given range of the axis.
        if (!(to > from)) continue;
        body += draw_bar(y, area, from + 0.5, std::max(0.5, to - from - 1.0), histogram.counts[i], slot_colour(0));
    }
    body += draw_horizontal_axis(histogram.x, x, area, true) +
            draw_vertical_references(histogram.vertical, x.scale, area);
    return open_svg(left + width + bar_chart_layout.right_margin, area.bottom() + frame_layout.horizontal_axis_height,
                    histogram.title) +
           body + "</svg>\n";
}

}  // namespace myo::report
