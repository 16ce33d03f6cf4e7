#include <algorithm>
#include <cmath>

#include "report/frame.hpp"
#include "report/markup.hpp"

namespace myo::report {
namespace {

struct ErrorBarChartLayout {
    double row_height = 30.0;
};
constexpr ErrorBarChartLayout error_bar_chart_layout;

/// Symbol of the reference value.
std::string diamond(double x, double y) {
    return "<path d=\"M" + pixel(x) + " " + pixel(y - 6.0) + "L" + pixel(x + 5.0) + " " + pixel(y) + "L" + pixel(x) +
           " " + pixel(y + 6.0) + "L" + pixel(x - 5.0) + " " + pixel(y) + "Z\" fill=\"" + std::string(ink::paper) +
           "\" stroke=\"" + std::string(slot_colour(1)) + "\" stroke-width=\"1.8\"/>\n";
}

/// Symbol of the estimate.
std::string dot(double x, double y) {
    return "<circle cx=\"" + pixel(x) + "\" cy=\"" + pixel(y) + "\" r=\"4.2\" fill=\"" + std::string(slot_colour(0)) +
           "\"/>\n";
}

/// Interval with end caps.
std::string draw_interval(double from, double to, double y) {
    return svg_line(from, y, to, y, slot_colour(0), 2.2) + svg_line(from, y - 5, from, y + 5, slot_colour(0), 1.6) +
           svg_line(to, y - 5, to, y + 5, slot_colour(0), 1.6);
}

/// One row: grid line, name, interval clipped to the area, reference and estimate, or a note if it cannot be shown.
std::string draw_row(const ErrorBarRow& row, const PlannedAxis& x, const Rectangle& area, double y) {
    std::string out = svg_line(area.left, y, area.right(), y, ink::grid, 1.0) +
                      svg_text(area.left - 9.0, y + 4.0, row.name,
                               {.size = 11.5, .anchor = Anchor::end, .colour = ink::text});
    const auto inside = [&](double px) {
        return std::isfinite(px) && px >= area.left - 0.5 && px <= area.right() + 0.5;
    };
    const double lowest = x.scale(row.lowest), highest = x.scale(row.highest), value = x.scale(row.value);
    if (std::isfinite(lowest) && std::isfinite(highest))
        out += draw_interval(std::clamp(lowest, area.left, area.right()), std::clamp(highest, area.left, area.right()),
                             y);
    if (row.reference && inside(x.scale(*row.reference))) out += diamond(x.scale(*row.reference), y);
    if (inside(value)) return out + dot(value, y);
    const bool told = std::isfinite(value);
    return out + svg_text(area.left + 8.0, y - 5.0, told ? "outside the axis" : "no value", {.halo = true});
}

}  // namespace

std::string svg(const ErrorBarChart& chart) {
    DataRange range(chart.x);
    double left = 60.0;
    bool referenced = false;
    for (const ErrorBarRow& row : chart.rows) {
        for (const double value : {row.value, row.lowest, row.highest}) range.add(value);
        if (row.reference) range.add(*row.reference);
        referenced = referenced || row.reference.has_value();
        left = std::max(left, text_width(row.name, 11.5) + 16.0);
    }
    // References must be visible, so they extend the range.
    for (const ReferenceLine& line : chart.vertical) range.add(line.value);
    // Long names must leave at least half of the width to the axis.
    left = std::min(left, 0.5 * chart.width_px);
    const double width = std::max(60.0, chart.width_px - left - 22.0);
    const PlannedAxis x = plan_axis(chart.x, range, 0.06, left, left + width);

    double title_height = 0.0, legend_height = 0.0;
    std::string body = draw_title(chart.title, 8.0, title_height);
    if (referenced && !chart.reference_name.empty())
        body += draw_legend(
            {{"estimate", draw_interval(0, 22, 0) + dot(11, 0)}, {chart.reference_name, diamond(11, 0)}}, left,
            title_height + 6.0, width, legend_height);
    const Rectangle area{
        left, title_height + legend_height + 12.0, width,
        error_bar_chart_layout.row_height * static_cast<double>(std::max<std::size_t>(1, chart.rows.size()))};
    // Grid first, rows on top of it.
    for (const double value : x.ticks.values)
        body += svg_line(x.scale(value), area.top, x.scale(value), area.bottom(), ink::grid, 1.0);
    body += draw_horizontal_axis(chart.x, x, area, true) + draw_vertical_references(chart.vertical, x.scale, area);
    for (std::size_t i = 0; i < chart.rows.size(); ++i)
        body += draw_row(chart.rows[i], x, area,
                         area.top + (static_cast<double>(i) + 0.5) * error_bar_chart_layout.row_height);
    return open_svg(left + width + 22.0, area.bottom() + frame_layout.horizontal_axis_height, chart.title) + body +
           "</svg>\n";
}

}  // namespace myo::report
