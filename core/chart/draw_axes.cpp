#include <algorithm>
#include <cmath>

#include "chart/draw_parts.hpp"

namespace myo::chart {
namespace {

struct AxisLook {
    // Distances of labels from the plot rectangle, and the length of a tick mark [px].
    double label_left = 7.0, label_below = 12.0, title_below = 29.0, title_above = 11.0, tick = 4.0;
    // The zero line is emphasised by its colour and stays thin [px].
    double zero_line = 0.8;
    // Names of categories are turned by this angle [degrees] about a point right of and below the tick [px].
    double turned = -35.0, turned_right = 4.0, turned_below = 11.0;
    // Dashes of reference lines [px].
    double dash = 4.0, gap = 3.0;
    // Distance of remarks from lines and edges [px], and the distance of their rows.
    double remark = 5.0, remark_row = 13.0;
};
constexpr AxisLook axis_look;

/// Line whose distance to the area is at most half a pixel.
bool within(double value, double lowest, double highest) {
    return std::isfinite(value) && value >= lowest - 0.5 && value <= highest + 0.5;
}

/// Line with the dashes of reference lines.
Stroke dashed(Stroke line) {
    line.dash = axis_look.dash;
    line.gap = axis_look.gap;
    return line;
}

/// The part of a span that the axis shows, as pixels along it; empty (from >= to) outside the axis.
struct VisiblePart {
    double from, to;
};
/// Part of a span between the edges of the area.
VisiblePart visible_part(const Span& span, const Layout& layout, const Rectangle& area) {
    return {std::clamp(layout.x.scale(span.from), area.left, area.right()),
            std::clamp(layout.x.scale(span.to), area.left, area.right())};
}

}  // namespace

Stroke straight(double x1, double y1, double x2, double y2, const Colour& colour, double width) {
    return {{{x1, x2}, {y1, y2}}, colour, width};
}

void draw_vertical_axis(const Axis& axis, const PlacedPanel& panel, const Layout& layout, const Palette& palette,
                        Drawing& drawing) {
    const LayoutStyle& style = layout.style;
    const Rectangle& area = panel.area;
    const bool names = !axis.categories.empty();
    for (std::size_t i = 0; i < panel.y.ticks.values.size(); ++i) {
        const double y = panel.y.scale(panel.y.ticks.values[i]);
        const bool zero = panel.y.ticks.values[i] == 0.0 && !names && !panel.y.scale.logarithmic;
        drawing.marks.push_back(straight(area.left, y, area.right(), y, zero ? palette.axis : palette.grid,
                                         zero ? axis_look.zero_line : style.grid));
        // Labels at the ends of a low plot stay at its height.
        const double half = 0.5 * style.text - 3.0;
        const double at = style.compact
                              ? std::clamp(y, area.top + half, std::max(area.top + half, area.bottom() - half))
                              : y;
        drawing.marks.push_back(Text{{area.left - axis_look.label_left, at},
                                     panel.y.ticks.labels[i],
                                     names ? palette.text : palette.quiet,
                                     names ? style.axis_title : style.text,
                                     Anchor::end});
    }
    // Rows with names need no title.
    if (names) return;
    // Compact charts have the title at the left edge, in the line of the legend; others above the area.
    const Point title = style.compact
                            ? Point{layout.frame.left + style.right_margin, area.top - 0.5 * style.panel_heading}
                            : Point{area.left, area.top - axis_look.title_above};
    drawing.marks.push_back(
        Text{title, axis_title(axis, panel.y.ticks), style.compact ? palette.text : palette.quiet, style.axis_title});
}

void draw_horizontal_axis(const Axis& axis, const Rectangle& area, bool labels, const Layout& layout,
                          const Palette& palette, Drawing& drawing) {
    const LayoutStyle& style = layout.style;
    const double y = area.bottom();
    const bool names = !axis.categories.empty();
    drawing.marks.push_back(straight(area.left, y, area.right(), y, palette.axis, style.grid));
    for (std::size_t i = 0; i < layout.x.ticks.values.size(); ++i) {
        const double x = layout.x.scale(layout.x.ticks.values[i]);
        if (style.vertical_grid && !names)
            drawing.marks.push_back(straight(x, area.top, x, y, palette.grid, style.grid));
        // Rows and compact charts have no room for tick marks.
        if (!style.compact && !names)
            drawing.marks.push_back(straight(x, y, x, y + axis_look.tick, palette.axis, style.grid));
        if (!labels) continue;
        Text label{{x, style.compact ? y + 0.5 * style.x_axis_height : y + axis_look.label_below},
                   layout.x.ticks.labels[i],
                   palette.quiet,
                   style.text,
                   Anchor::middle};
        if (layout.turned) {
            label.at = {x + axis_look.turned_right, y + axis_look.turned_below};
            label.anchor = Anchor::end;
            label.turned = axis_look.turned;
        } else if (style.compact) {
            // Labels at both ends stay inside the area, so that those of neighbouring plots do not touch.
            const double half = std::min(0.5 * layout.x_label_widths[i], 0.5 * area.width);
            label.at.x = std::clamp(x, area.left + half, area.right() - half);
        }
        drawing.marks.push_back(std::move(label));
    }
    if (labels && !style.compact && !names)
        drawing.marks.push_back(Text{{area.left + 0.5 * area.width, y + axis_look.title_below},
                                     axis_title(axis, layout.x.ticks),
                                     palette.quiet,
                                     style.axis_title,
                                     Anchor::middle});
}

void draw_references(const Panel& panel, const PlacedPanel& placed, const Layout& layout, const Palette& palette,
                     Drawing& drawing) {
    const LayoutStyle& style = layout.style;
    const Rectangle& area = placed.area;
    for (const ReferenceLine& line : panel.horizontal) {
        const double y = placed.y.scale(line.value);
        if (!within(y, area.top, area.bottom())) continue;
        drawing.marks.push_back(dashed(straight(area.left, y, area.right(), y, palette.quiet, style.grid)));
        // A label that would leave the area goes below its line.
        const double above = y - 0.75 * style.text;
        drawing.marks.push_back(
            Text{{area.right() - axis_look.remark, above < area.top + 0.5 * style.text ? y + 0.75 * style.text : above},
                 line.label,
                 palette.text,
                 style.text,
                 Anchor::end,
                 false,
                 palette.paper});
    }
    int row = 0;  // labels of successive lines use three rows, so that they do not overlap
    for (const ReferenceLine& line : panel.vertical) {
        const double x = layout.x.scale(line.value);
        if (!within(x, area.left, area.right())) continue;
        drawing.marks.push_back(dashed(straight(x, area.top, x, area.bottom(), palette.quiet, style.grid)));
        if (line.label.empty()) continue;
        // A label that would leave the area goes to the left of its line.
        const bool to_left = x + axis_look.remark + estimated_text_width(line.label, style.text) > area.right();
        drawing.marks.push_back(
            Text{{to_left ? x - axis_look.remark : x + axis_look.remark, area.top + 7.0 + axis_look.remark_row * row},
                 line.label,
                 palette.text,
                 style.text,
                 to_left ? Anchor::end : Anchor::start,
                 false,
                 palette.paper});
        row = (row + 1) % 3;
    }
    for (const Note& note : panel.notes)
        if (const double y = placed.y.scale(note.y); within(y, area.top, area.bottom()))
            drawing.marks.push_back(Text{
                {area.left + 8.0, y - 9.0}, note.text, palette.quiet, style.text, Anchor::start, false, palette.paper});
}

void draw_span_shades(const Panel& panel, const PlacedPanel& placed, const Layout& layout, const Palette& palette,
                      Drawing& drawing) {
    const Rectangle& area = placed.area;
    for (const Span& span : panel.spans) {
        const auto [from, to] = visible_part(span, layout, area);
        if (to > from) drawing.marks.push_back(Box{{from, area.top, to - from, area.height}, palette.shade});
    }
}

void draw_span_labels(const Panel& panel, const PlacedPanel& placed, const Layout& layout, const Palette& palette,
                      Drawing& drawing) {
    const Rectangle& area = placed.area;
    for (const Span& span : panel.spans) {
        const auto [from, to] = visible_part(span, layout, area);
        if (to > from)
            drawing.marks.push_back(Text{{from + axis_look.remark, area.bottom() - 10.0},
                                         span.label,
                                         palette.quiet,
                                         layout.style.text,
                                         Anchor::start,
                                         false,
                                         palette.paper});
    }
}

}  // namespace myo::chart
