#include "plot/plot_svg.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace myo::ui::plot {
namespace {

// Size of one plot and its drawing area [SVG pixels], chosen for a column of a page.
constexpr double width = 800.0, height = 260.0, left = 64.0, right = 784.0, top = 30.0, bottom = 232.0;

/// Two decimals of an SVG pixel: exact enough for print, and short.
std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", value);
    return text;
}

std::string hex(const ImVec4& color) {
    const auto byte = [](float part) {
        return static_cast<unsigned>(std::lround(255.0f * std::clamp(part, 0.0f, 1.0f)));
    };
    char text[16];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", byte(color.x), byte(color.y), byte(color.z));
    return text;
}

/// Names come from experiment files and may hold characters with a meaning in XML.
std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
    return result;
}

std::string label(double x, double y, const char* anchor, const ImVec4& color, const std::string& text) {
    return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" text-anchor=\"" + anchor + "\" fill=\"" + hex(color) +
           "\">" + escaped(text) + "</text>\n";
}

/// A line element; coordinates and thickness in SVG pixels.
std::string straight(double x0, double y0, double x1, double y1, const ImVec4& color, double thickness) {
    return "<line x1=\"" + number(x0) + "\" y1=\"" + number(y0) + "\" x2=\"" + number(x1) + "\" y2=\"" + number(y1) +
           "\" stroke=\"" + hex(color) + "\" stroke-width=\"" + number(thickness) + "\"/>\n";
}

std::string circle(double x, double y, double radius) {
    return "<circle cx=\"" + number(x) + "\" cy=\"" + number(y) + "\" r=\"" + number(radius) + "\"/>\n";
}

/// Dots outside the visible ranges are left out, so that the file holds only what is seen.
std::string dots(const SeenPlot& seen, const PlotSeries& series) {
    std::string svg = "<g fill=\"" + hex(series.color) + "\">\n";
    for (Eigen::Index i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
        const double x = series.x[i], y = series.y[i];
        if (x >= seen.x.lowest && x <= seen.x.highest && y >= seen.y.lowest && y <= seen.y.highest)
            svg += circle(to_pixel(seen.x, x, left, right), to_pixel(seen.y, y, bottom, top), 1.8);
    }
    return svg + "</g>\n";
}

/// One path for the whole curve. Segments are cut at the ends of the x range; a NaN or a segment left out starts a new
/// subpath.
std::string curve(const SeenPlot& seen, const PlotSeries& series) {
    std::string path;
    double end = NAN;  // x of the last path point; NaN before the first
    for (Eigen::Index i = 1; i < std::min(series.x.size(), series.y.size()); ++i) {
        const double x0 = series.x[i - 1], x1 = series.x[i], y0 = series.y[i - 1], y1 = series.y[i];
        const double from = std::max(x0, seen.x.lowest), to = std::min(x1, seen.x.highest);
        if (!std::isfinite(y0) || !std::isfinite(y1) || !(from < to)) continue;
        const auto point = [&](double x) {
            const double y = y0 + (y1 - y0) * (x - x0) / (x1 - x0);
            return number(to_pixel(seen.x, x, left, right)) + " " + number(to_pixel(seen.y, y, bottom, top));
        };
        if (end != from) path += (path.empty() ? "M" : " M") + point(from);
        path += " L" + point(to);
        end = to;
    }
    return path.empty()
               ? path
               : "<path fill=\"none\" stroke=\"" + hex(series.color) + "\" stroke-width=\"1.6\" d=\"" + path + "\"/>\n";
}

std::string frame(const SeenPlot& seen, const platform::Theme& theme) {
    std::string svg = "<rect x=\"" + number(left) + "\" y=\"" + number(top) + "\" width=\"" + number(right - left) +
                      "\" height=\"" + number(bottom - top) + "\" fill=\"" + hex(theme.plot) + "\"/>\n";
    const Ticks x_ticks = make_ticks(seen.x, 10), y_ticks = make_ticks(seen.y, 8);
    for (const double v : x_ticks.values) {
        const double x = to_pixel(seen.x, v, left, right);
        svg += straight(x, top, x, bottom, theme.border, 1.0) +
               label(x, bottom + 16.0, "middle", theme.muted, tick_label(v, x_ticks.step) + " " + seen.plot.x_unit);
    }
    for (const double v : y_ticks.values) {
        const double y = to_pixel(seen.y, v, bottom, top);
        svg += straight(left, y, right, y, theme.border, 1.0) +
               label(left - 6.0, y + 4.0, "end", theme.muted, tick_label(v, y_ticks.step));
    }
    return svg + label(left, top - 10.0, "start", theme.text, seen.plot.title);
}

std::string legend(const SeenPlot& seen, const platform::Theme& theme) {
    std::string svg;
    double end = right;
    for (std::size_t i = seen.plot.series.size(); i-- > 0;) {
        const PlotSeries& series = seen.plot.series[i];
        svg += label(end, top - 10.0, "end", theme.text, series.name);
        // The viewer's font is unknown, so each character gets the width of a wide letter.
        const double begin = end - 7.0 * static_cast<double>(series.name.size()) - 22.0;
        svg += series.dots ? "<g fill=\"" + hex(series.color) + "\">" + circle(begin + 9.0, top - 14.0, 3.0) + "</g>\n"
                           : straight(begin, top - 14.0, begin + 16.0, top - 14.0, series.color, 2.0);
        end = begin - 12.0;
    }
    return svg;
}

}  // namespace

std::string plots_svg(const std::vector<SeenPlot>& plots, const platform::Theme& theme) {
    const std::string total = number(height * static_cast<double>(plots.size()));
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number(width) + "\" height=\"" + total +
                      "\" viewBox=\"0 0 " + number(width) + " " + total +
                      // Curves may leave the y range; the clip path cuts them at the frame.
                      "\" font-family=\"sans-serif\" font-size=\"12\">\n<clipPath id=\"inside\"><rect x=\"" +
                      number(left) + "\" y=\"" + number(top) + "\" width=\"" + number(right - left) + "\" height=\"" +
                      number(bottom - top) + "\"/></clipPath>\n<rect width=\"" + number(width) + "\" height=\"" +
                      total + "\" fill=\"" + hex(theme.plot) + "\"/>\n";
    for (std::size_t p = 0; p < plots.size(); ++p) {
        svg += "<g transform=\"translate(0 " + number(height * static_cast<double>(p)) + ")\">\n" +
               frame(plots[p], theme);
        if (plots[p].plot.legend) svg += legend(plots[p], theme);
        svg += "<g clip-path=\"url(#inside)\">\n";
        for (const PlotSeries& series : plots[p].plot.series)
            svg += series.dots ? dots(plots[p], series) : curve(plots[p], series);
        svg += "</g>\n</g>\n";
    }
    return svg + "</svg>\n";
}

}  // namespace myo::ui::plot
