#include <algorithm>
#include <cmath>

#include "report/frame.hpp"

namespace myo::report {

double label_room(const Ticks& ticks) {
    double widest = 0.0;
    for (const std::string& label : ticks.labels) widest = std::max(widest, text_width(label));
    return widest + 10.0;
}

std::string draw_vertical_axis(const Axis& axis, const PlannedAxis& plan, const Rectangle& area) {
    std::string out;
    for (std::size_t i = 0; i < plan.ticks.values.size(); ++i) {
        const double y = plan.scale(plan.ticks.values[i]);
        // The zero line is emphasised.
        const bool zero = plan.ticks.values[i] == 0.0;
        out += svg_line(area.left, y, area.right(), y, zero ? ink::axis : ink::grid, zero ? 0.8 : 1.0);
        out += svg_text(area.left - 7.0, y + 4.0, plan.ticks.labels[i], {.anchor = Anchor::end});
    }
    return out +
           svg_text(area.left, area.top - 7.0, axis_title(axis, plan.ticks), {.size = 11.5, .colour = ink::quiet});
}

std::string draw_horizontal_axis(const Axis& axis, const PlannedAxis& plan, const Rectangle& area, bool with_labels) {
    const double y = area.bottom();
    std::string out = svg_line(area.left, y, area.right(), y, ink::axis, 1.0);
    double free_from = -1e9;  // skips labels that would overlap on a narrow logarithmic axis
    for (std::size_t i = 0; i < plan.ticks.values.size(); ++i) {
        const double x = plan.scale(plan.ticks.values[i]);
        out += svg_line(x, y, x, y + 4.0, ink::axis, 1.0);
        // Labels are centred at their ticks.
        const double half = 0.5 * text_width(plan.ticks.labels[i]);
        if (!with_labels || x - half < free_from) continue;
        out += svg_text(x, y + 16.0, plan.ticks.labels[i], {.anchor = Anchor::middle});
        free_from = x + half + 4.0;
    }
    if (with_labels)
        out += svg_text(area.left + 0.5 * area.width, y + 33.0, axis_title(axis, plan.ticks),
                        {.size = 11.5, .anchor = Anchor::middle});
    return out;
}

std::string draw_vertical_references(const std::vector<ReferenceLine>& lines, const Scale& scale,
                                     const Rectangle& area) {
    std::string out;
    int row = 0;  // labels of successive lines use three rows, so that they do not overlap
    for (const ReferenceLine& line : lines) {
        const double x = scale(line.value);
        if (!std::isfinite(x) || x < area.left - 0.5 || x > area.right() + 0.5) continue;
        out += svg_line(x, area.top, x, area.bottom(), ink::quiet, 1.0, "4 3");
        // A label that would leave the area goes to the left of its line.
        const bool to_left = x + 5.0 + text_width(line.label) > area.right();
        out += svg_text(to_left ? x - 5.0 : x + 5.0, area.top + 11.0 + 13.0 * row, line.label,
                        {.anchor = to_left ? Anchor::end : Anchor::start, .colour = ink::text, .halo = true});
        if (!line.label.empty()) row = (row + 1) % 3;
    }
    return out;
}

}  // namespace myo::report
