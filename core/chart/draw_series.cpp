#include <algorithm>
#include <cmath>

#include "chart/draw_parts.hpp"

namespace myo::chart {
namespace {

struct SeriesLook {
    // Dashes of dashed curves, and of those that use a colour for the second time [px].
    double dash = 6.0, gap = 4.0, dotted_dash = 2.0, dotted_gap = 3.0;
    // Opacity of bands, and of entries of hidden series.
    double band = 0.15, hidden = 0.35;
    // Diameter of a sample between two gaps, which would be an invisible line, and of an estimate, in dots.
    double lonely = 0.57, estimate = 2.0;
    // Interval of an estimate: thickness of line and caps, half height of the caps [px].
    double interval = 2.2, cap = 1.6, cap_height = 5.0;
    // Half width and half height of a diamond, and its edge [px].
    double diamond_width = 5.0, diamond_height = 6.0, diamond_edge = 1.8;
    // Bars wider than this have round corners of this radius; space between bars [px].
    double round_from = 8.0, radius = 1.5, between_bars = 1.0;
    // Box of a bar in the legend [px].
    double sample_box = 12.0;
};
constexpr SeriesLook series_look;

/// Appends a point.
void append(Polyline& curve, double x, double y) {
    curve.x.push_back(x);
    curve.y.push_back(y);
}

/// Samples of a series in pixels; what an axis cannot show is a gap.
Polyline in_pixels(const Series& series, const Scale& x, const Scale& y) {
    Polyline curve;
    const std::size_t count = std::min(series.x.size(), series.y.size());
    curve.x.reserve(count);
    curve.y.reserve(count);
    for (std::size_t i = 0; i < count; ++i) append(curve, x(series.x[i]), y(series.y[i]));
    return curve;
}

/// Ends the present part of a curve; repeated gaps are one.
void append_gap(Polyline& curve) {
    if (!curve.x.empty() && std::isfinite(curve.x.back())) append(curve, NAN, NAN);
}

/// The parts of a curve between two vertical lines. Segments that cross a line are cut there.
Polyline cut(const Polyline& curve, double left, double right) {
    if (std::all_of(curve.x.begin(), curve.x.end(), [&](double x) { return !(x < left || x > right); })) return curve;
    Polyline out;
    const auto inside = [&](std::size_t i) { return curve.x[i] >= left && curve.x[i] <= right; };
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        if (!curve.has_point(i)) {
            append_gap(out);
            continue;
        }
        if (i > 0 && curve.has_point(i - 1)) {
            const double x0 = curve.x[i - 1], x1 = curve.x[i], y0 = curve.y[i - 1], y1 = curve.y[i];
            // Crossed lines in the order of the segment.
            const double first = x0 < x1 ? left : right, second = x0 < x1 ? right : left;
            for (const double line : {first, second})
                if ((x0 < line) != (x1 < line) && x0 != line && x1 != line) {
                    if (line == first && !inside(i - 1)) append_gap(out);
                    append(out, line, y0 + (y1 - y0) * (line - x0) / (x1 - x0));
                }
        }
        if (inside(i))
            append(out, curve.x[i], curve.y[i]);
        else
            append_gap(out);
    }
    return out;
}

/// Samples between two gaps, which a line would not show.
Polyline lonely_samples(const Polyline& curve) {
    Polyline lonely;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        const bool before = i > 0 && curve.has_point(i - 1), after = i + 1 < curve.x.size() && curve.has_point(i + 1);
        if (curve.has_point(i) && !before && !after) append(lonely, curve.x[i], curve.y[i]);
    }
    return lonely;
}

/// Samples in the area and its rim. Cutting adds points at the edges, which are no samples.
Polyline samples_within(const Polyline& samples, const Rectangle& area, double rim) {
    Polyline within;
    for (std::size_t i = 0; i < samples.x.size(); ++i)
        if (samples.has_point(i) && samples.x[i] >= area.left - 0.5 && samples.x[i] <= area.right() + 0.5 &&
            samples.y[i] >= area.top - rim && samples.y[i] <= area.bottom() + rim)
            append(within, samples.x[i], samples.y[i]);
    return within;
}

/// Curve with the dashes of its look.
Stroke curve_stroke(Polyline points, const LegendEntry& look, double width) {
    Stroke stroke{std::move(points), look.colour, width};
    if (look.style == SeriesStyle::dashed)
        // A dashed series keeps its pattern, also beyond the palette.
        stroke.dash = series_look.dash, stroke.gap = series_look.gap;
    else if (look.dotted)
        stroke.dash = series_look.dotted_dash, stroke.gap = series_look.dotted_gap;
    return stroke;
}

/// Pale band of half the width to both sides of the curve.
void draw_band(const Series& series, const LegendEntry& look, const Scale& x, const Scale& y, Drawing& drawing) {
    if (series.half_width.empty()) return;
    Band band;
    band.colour = faded(look.colour, series_look.band);
    for (std::size_t i = 0; i < std::min({series.x.size(), series.y.size(), series.half_width.size()}); ++i) {
        band.x.push_back(x(series.x[i]));
        band.upper.push_back(y(series.y[i] + series.half_width[i]));
        band.lower.push_back(y(series.y[i] - series.half_width[i]));
    }
    drawing.marks.push_back(std::move(band));
}

/// Bars between zero and the values, in either order.
void draw_bars(const Series& series, const LegendEntry& look, const PlacedPanel& placed, const Scale& x,
               Drawing& drawing) {
    const Rectangle& area = placed.area;
    const Scale& y = placed.y.scale;
    // A logarithmic axis has no zero: bars start at its lower end.
    const double base = y(y.logarithmic ? y.lowest : std::clamp(0.0, y.lowest, y.highest));
    for (std::size_t i = 0; i < std::min(series.y.size(), series.ends.size()); ++i) {
        const double from = std::clamp(x(series.ends[i].lowest), area.left, area.right());
        const double to = std::clamp(x(series.ends[i].highest), area.left, area.right());
        if (!(to > from) || !std::isfinite(y(series.y[i]))) continue;
        // Bars that leave the axis end at its edge.
        const double end = std::clamp(y(series.y[i]), area.top, area.bottom());
        const double width = std::max(0.5, to - from - series_look.between_bars);
        drawing.marks.push_back(
            Box{{from + 0.5 * series_look.between_bars, std::min(base, end), width, std::abs(end - base)},
                look.colour,
                width > series_look.round_from ? series_look.radius : 0.0});
    }
}

/// Interval with end caps.
void draw_interval(double from, double to, double y, const Colour& colour, Drawing& drawing) {
    drawing.marks.push_back(straight(from, y, to, y, colour, series_look.interval));
    for (const double end : {from, to})
        drawing.marks.push_back(
            straight(end, y - series_look.cap_height, end, y + series_look.cap_height, colour, series_look.cap));
}

/// Diamond about a point, filled with the colour of the paper.
void draw_diamond(double x, double y, const Colour& edge, const Palette& palette, Drawing& drawing) {
    const double w = series_look.diamond_width, h = series_look.diamond_height;
    drawing.marks.push_back(
        Polygon{{{x, x + w, x, x - w}, {y - h, y, y + h, y}}, palette.paper, edge, series_look.diamond_edge});
}

}  // namespace

void draw_series(const Series& series, const LegendEntry& look, const PlacedPanel& placed, const Layout& layout,
                 const Palette& palette, Drawing& drawing) {
    const Rectangle& area = placed.area;
    const Scale &x = layout.x.scale, &y = placed.y.scale;
    if (series.style == SeriesStyle::bars) return draw_bars(series, look, placed, x, drawing);
    draw_band(series, look, x, y, drawing);
    const Polyline samples = in_pixels(series, x, y);
    for (std::size_t i = 0; i < std::min(series.ends.size(), samples.y.size()); ++i) {
        const double from = x(series.ends[i].lowest), to = x(series.ends[i].highest);
        if (std::isfinite(from) && std::isfinite(to) && std::isfinite(samples.y[i]))
            draw_interval(std::clamp(from, area.left, area.right()), std::clamp(to, area.left, area.right()),
                          samples.y[i], look.colour, drawing);
    }
    if (series.style == SeriesStyle::diamonds) {
        const Polyline centres = samples_within(samples, area, series_look.diamond_height);
        for (std::size_t i = 0; i < centres.x.size(); ++i)
            draw_diamond(centres.x[i], centres.y[i], look.colour, palette, drawing);
        return;
    }
    // Cut before decimating: pixel columns outside the area would be kept in vain.
    if (series.style != SeriesStyle::dots)
        drawing.marks.push_back(curve_stroke(decimate(cut(samples, area.left, area.right())), look, layout.style.line));
    if (series.style == SeriesStyle::dots || series.style == SeriesStyle::line_and_dots) {
        drawing.marks.push_back(Dots{decimate(samples_within(samples, area, layout.style.dot)), look.colour,
                                     layout.style.dot * (series.ends.empty() ? 1.0 : series_look.estimate)});
    } else if (Polyline lonely = lonely_samples(samples); !lonely.x.empty()) {
        drawing.marks.push_back(Dots{std::move(lonely), look.colour, layout.style.dot * series_look.lonely});
    }
}

void draw_legend_entry(const PlacedEntry& placed, const LayoutStyle& style, const Palette& palette, Drawing& drawing) {
    LegendEntry look = placed.entry;
    // A hidden curve keeps its entry, dimmed, so that a second click shows the curve again.
    const double opacity = look.hidden ? series_look.hidden : 1.0;
    look.colour = faded(look.colour, opacity);
    const double left = placed.box.left, right = left + style.legend_sample, middle = 0.5 * (left + right);
    const double y = placed.box.top + 0.5 * placed.box.height;
    const bool dots = look.style == SeriesStyle::dots || look.style == SeriesStyle::line_and_dots;
    if (look.interval) draw_interval(left, right, y, look.colour, drawing);
    if (look.style == SeriesStyle::bars) {
        const double side = series_look.sample_box;
        drawing.marks.push_back(
            Box{{middle - 0.5 * side, y - 0.5 * side, side, side}, look.colour, series_look.radius});
    } else if (look.style == SeriesStyle::diamonds) {
        draw_diamond(middle, y, look.colour, palette, drawing);
    } else if (look.style != SeriesStyle::dots) {
        drawing.marks.push_back(curve_stroke({{left, right}, {y, y}}, look, style.line));
    }
    if (dots)
        drawing.marks.push_back(
            Dots{{{middle}, {y}}, look.colour, style.dot * (look.interval ? series_look.estimate : 1.0)});
    drawing.marks.push_back(
        Text{{right + 0.5 * style.legend, y}, look.name, faded(palette.legend, opacity), style.legend});
}

}  // namespace myo::chart
