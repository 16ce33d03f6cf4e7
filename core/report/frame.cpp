#include "report/frame.hpp"

#include <algorithm>
#include <cmath>

#include "report/markup.hpp"

namespace myo::report {

double Scale::operator()(double value) const {
    // Fraction of the range, 0 at `lowest` and 1 at `highest`; linear in the logarithm for a logarithmic axis.
    const double s = logarithmic ? std::log(value / lowest) / std::log(highest / lowest)
                                 : (value - lowest) / (highest - lowest);
    return from_px + s * (to_px - from_px);
}

void DataRange::add(double value) {
    // Values that cannot be drawn must not determine the range.
    if (!std::isfinite(value) || (logarithmic && value <= 0.0)) return;
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
}

PlannedAxis plan_axis(const Axis& axis, const DataRange& data, double padding, double from_px, double to_px) {
    double lowest = data.lowest, highest = data.highest;
    // Labels need about 80 px side by side and 42 px one above the other.
    const double length = std::abs(to_px - from_px);
    const int wanted = std::clamp(static_cast<int>(length / (to_px > from_px ? 80.0 : 42.0)), 2, 10);
    PlannedAxis plan;
    if (axis.logarithmic) {
        // Padding of a logarithmic axis is a factor.
        if (lowest > 0.0 && lowest < highest) {
            const double rim = std::pow(highest / lowest, padding);
            lowest /= rim;
            highest *= rim;
        }
        lowest = axis.lowest.value_or(lowest);
        highest = axis.highest.value_or(highest);
        plan.ticks = logarithmic_ticks(lowest, highest, wanted);
    } else {
        if (axis.include_zero && lowest <= highest) {
            lowest = std::min(lowest, 0.0);
            highest = std::max(highest, 0.0);
        }
        // Before padding: a constant curve gets a range around its value.
        make_drawable(lowest, highest);
        const double rim = padding * (highest - lowest);
        // Axes that start at zero keep zero as their end, without padding.
        if (!(axis.include_zero && lowest == 0.0)) lowest -= rim;
        if (!(axis.include_zero && highest == 0.0)) highest += rim;
        lowest = axis.lowest.value_or(lowest);
        highest = axis.highest.value_or(highest);
        plan.ticks = linear_ticks(lowest, highest, wanted);
    }
    plan.scale = {plan.ticks.lowest, plan.ticks.highest, from_px, to_px, axis.logarithmic};
    return plan;
}

std::string axis_title(const Axis& axis, const Ticks& ticks) {
    std::string unit = ticks.factor;
    // The power of ten that the labels were divided by belongs to the unit.
    if (!axis.unit.empty()) unit += (unit.empty() ? "" : " ") + axis.unit;
    if (unit.empty()) return axis.label;
    return axis.label + (axis.label.empty() ? "[" : " [") + unit + "]";
}

std::string open_svg(double width, double height, const std::string& title) {
    // role and aria-label make the figure accessible to screen readers.
    const std::string label = escape_markup(title.empty() ? "figure" : title);
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + pixel(width) + " " + pixel(height) +
           "\" role=\"img\" aria-label=\"" + label +
           "\" font-family=\"system-ui, -apple-system, 'Segoe UI', Inter, Roboto, 'DejaVu Sans', sans-serif\">\n" +
           svg_box({0, 0, width, height}, ink::paper);
}

std::string svg_text(double x, double y, std::string_view text, const TextStyle& style) {
    if (text.empty()) return {};
    std::string out = "<text x=\"" + pixel(x) + "\" y=\"" + pixel(y) + "\" font-size=\"" + pixel(style.size) +
                      "\" fill=\"" + std::string(style.colour) + "\"";
    if (style.anchor == Anchor::middle) out += " text-anchor=\"middle\"";
    if (style.anchor == Anchor::end) out += " text-anchor=\"end\"";
    if (style.bold) out += " font-weight=\"600\"";
    if (style.halo)
        out += " stroke=\"" + std::string(ink::paper) +
               // paint-order draws the outline below the glyphs.
               "\" stroke-width=\"3\" stroke-linejoin=\"round\" paint-order=\"stroke\"";
    return out + ">" + escape_markup(text) + "</text>\n";
}

std::string svg_line(double x1, double y1, double x2, double y2, std::string_view colour, double width,
                     std::string_view dash) {
    std::string out = "<line x1=\"" + pixel(x1) + "\" y1=\"" + pixel(y1) + "\" x2=\"" + pixel(x2) + "\" y2=\"" +
                      pixel(y2) + "\" stroke=\"" + std::string(colour) + "\" stroke-width=\"" + pixel(width) + "\"";
    if (!dash.empty()) out += " stroke-dasharray=\"" + std::string(dash) + "\"";
    return out + "/>\n";
}

std::string svg_box(const Rectangle& box, std::string_view colour, double radius, double opacity) {
    std::string out = "<rect x=\"" + pixel(box.left) + "\" y=\"" + pixel(box.top) + "\" width=\"" +
                      pixel(std::max(0.0, box.width)) + "\" height=\"" + pixel(std::max(0.0, box.height)) +
                      "\" fill=\"" + std::string(colour) + "\"";
    if (radius > 0.0) out += " rx=\"" + pixel(radius) + "\"";
    if (opacity < 1.0) out += " fill-opacity=\"" + pixel(opacity) + "\"";
    return out + "/>\n";
}

// Mean glyph width of common sans-serif fonts: 0.57 of the font size.
double text_width(std::string_view text, double size) { return 0.57 * size * character_count(text); }

std::string_view slot_colour(int slot) {
    if (slot < 0) return ink::text;
    return series_palette[static_cast<std::size_t>(slot) % series_palette.size()];
}

std::string draw_title(const std::string& title, double left, double& height) {
    height = title.empty() ? 0.0 : 24.0;
    return svg_text(left, 20.0, title, {.size = 14.0, .colour = ink::text, .bold = true});
}

std::string draw_legend(const std::vector<LegendEntry>& entries, double left, double top, double width,
                        double& height) {
    std::string out;
    double x = left, y = top + 12.0;
    for (const LegendEntry& entry : entries) {
        // 22 px for the symbol and a space of 6 px.
        const double needed = 28.0 + text_width(entry.name, 11.5);
        // Wrap, but never leave a line empty.
        if (x > left && x + needed > left + width) {
            x = left;
            y += 18.0;
        }
        out += "<g transform=\"translate(" + pixel(x) + " " + pixel(y - 4.0) + ")\">" + entry.sign + "</g>\n";
        out += svg_text(x + 28.0, y, entry.name, {.size = 11.5, .colour = ink::text});
        x += needed + 18.0;
    }
    height = entries.empty() ? 0.0 : y - top + 8.0;
    return out;
}

}  // namespace myo::report
