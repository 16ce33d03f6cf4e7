#include "chart/svg.hpp"

#include <algorithm>
#include <cmath>

#include "base/markup.hpp"

namespace myo::chart {
namespace {

struct SvgPolicy {
    // From the vertical middle of letters down to their base line, in font sizes.
    double base_line = 0.36;
    // Thickness of the outline of text over curves [px].
    double halo = 3.0;
};
constexpr SvgPolicy svg_policy;

/// " name="value"".
std::string attribute(const char* name, double value) {
    return " " + std::string(name) + "=\"" + svg_number(value) + "\"";
}

/// Attributes of a colour; `what` is fill or stroke.
std::string painted(const std::string& what, const Colour& colour) {
    std::string out = " " + what + "=\"" + hex_of(colour) + "\"";
    if (colour.opacity < 1.0) out += attribute((what + "-opacity").c_str(), colour.opacity);
    return out;
}

/// Coordinates as the attributes of SVG take them: "x y".
std::string point(double x, double y) { return svg_number(x) + " " + svg_number(y); }

std::string written(const Box& box) {
    std::string out = "<rect" + attribute("x", box.area.left) + attribute("y", box.area.top) +
                      attribute("width", std::max(0.0, box.area.width)) +
                      attribute("height", std::max(0.0, box.area.height)) + painted("fill", box.colour);
    if (box.radius > 0.0) out += attribute("rx", box.radius);
    return out + "/>\n";
}

/// Attribute of a dashed line; empty for a solid one.
std::string dashes(const Stroke& stroke) {
    if (stroke.dash <= 0.0) return {};
    return " stroke-dasharray=\"" + point(stroke.dash, stroke.gap) + "\"";
}

std::string written(const Stroke& stroke) {
    const Polyline& curve = stroke.points;
    const std::string look = painted("stroke", stroke.colour) + attribute("stroke-width", stroke.width) +
                             dashes(stroke);
    // Most strokes are straight lines, for which SVG has a shorter element.
    if (curve.x.size() == 2 && curve.has_point(0) && curve.has_point(1))
        return "<line" + attribute("x1", curve.x[0]) + attribute("y1", curve.y[0]) + attribute("x2", curve.x[1]) +
               attribute("y2", curve.y[1]) + look + "/>\n";
    std::string data;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        if (!curve.has_point(i)) continue;
        const bool starts = i == 0 || !curve.has_point(i - 1);
        const bool ends = i + 1 == curve.x.size() || !curve.has_point(i + 1);
        // A point between two gaps has no line; draw_series() marks it by a dot.
        if (!(starts && ends)) data += (starts ? "M" : "L") + point(curve.x[i], curve.y[i]);
    }
    if (data.empty()) return {};
    return "<path d=\"" + data + "\" fill=\"none\"" + look + " stroke-linejoin=\"round\"/>\n";
}

// Each part of the band between gaps is a closed outline: forwards along the upper edge, back along the lower one.
std::string written(const Band& band) {
    std::string data, back;
    for (std::size_t i = 0; i <= band.x.size(); ++i) {
        // One index beyond the end closes the last part.
        if (i < band.x.size() && std::isfinite(band.x[i]) && std::isfinite(band.upper[i]) &&
            std::isfinite(band.lower[i])) {
            data += (back.empty() ? "M" : "L") + point(band.x[i], band.upper[i]);
            back = "L" + point(band.x[i], band.lower[i]) + back;
        } else if (!back.empty()) {
            data += back + "Z";
            back.clear();
        }
    }
    return data.empty() ? data : "<path d=\"" + data + "\"" + painted("fill", band.colour) + "/>\n";
}

// A dot is a stroke of zero length with round ends: the shortest SVG for many dots.
std::string written(const Dots& dots) {
    std::string data;
    for (std::size_t i = 0; i < dots.centres.x.size(); ++i)
        if (dots.centres.has_point(i)) data += "M" + point(dots.centres.x[i], dots.centres.y[i]) + "h0";
    if (data.empty()) return {};
    return "<path d=\"" + data + "\" fill=\"none\"" + painted("stroke", dots.colour) +
           attribute("stroke-width", dots.diameter) + " stroke-linecap=\"round\"/>\n";
}

std::string written(const Polygon& polygon) {
    std::string data;
    for (std::size_t i = 0; i < polygon.corners.x.size(); ++i)
        data += (i == 0 ? "M" : "L") + point(polygon.corners.x[i], polygon.corners.y[i]);
    return "<path d=\"" + data + "Z\"" + painted("fill", polygon.fill) + painted("stroke", polygon.edge) +
           attribute("stroke-width", polygon.width) + "/>\n";
}

std::string written(const Text& text) {
    if (text.text.empty()) return {};
    const double down = svg_policy.base_line * text.size;
    std::string out = "<text" + attribute("x", text.at.x) + attribute("y", text.at.y + down) +
                      attribute("font-size", text.size) + painted("fill", text.colour);
    if (text.turned != 0.0)
        out += " transform=\"rotate(" + svg_number(text.turned) + " " + point(text.at.x, text.at.y) + ")\"";
    if (text.anchor == Anchor::middle) out += " text-anchor=\"middle\"";
    if (text.anchor == Anchor::end) out += " text-anchor=\"end\"";
    if (text.bold) out += " font-weight=\"600\"";
    // paint-order draws the outline below the glyphs.
    if (text.halo)
        out += painted("stroke", *text.halo) + attribute("stroke-width", svg_policy.halo) +
               " stroke-linejoin=\"round\" paint-order=\"stroke\"";
    return out + ">" + escape_markup(text.text) + "</text>\n";
}

// A nested document clips its content without an id.
std::string written(const Clip& clip) {
    if (!clip.area) return "</svg>\n";
    const Rectangle& a = *clip.area;
    return "<svg" + attribute("x", a.left) + attribute("y", a.top) + attribute("width", a.width) +
           attribute("height", a.height) + " viewBox=\"" + point(a.left, a.top) + " " + point(a.width, a.height) +
           "\" overflow=\"hidden\">\n";
}

}  // namespace

std::string svg(const Drawing& drawing, bool sized) {
    const Rectangle& frame = drawing.frame;
    std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\"";
    if (sized) out += attribute("width", frame.width) + attribute("height", frame.height);
    // role and aria-label make the figure accessible to screen readers.
    out += " viewBox=\"" + point(frame.left, frame.top) + " " + point(frame.width, frame.height) +
           "\" role=\"img\" aria-label=\"" + escape_markup(drawing.title.empty() ? "figure" : drawing.title) +
           "\" font-family=\"system-ui, -apple-system, 'Segoe UI', Inter, Roboto, 'DejaVu Sans', sans-serif\">\n";
    for (const Mark& mark : drawing.marks) out += std::visit([](const auto& each) { return written(each); }, mark);
    return out + "</svg>\n";
}

std::string svg(const Chart& chart) {
    const Palette& palette = print_palette();
    return svg(draw(chart, lay_out(chart, LayoutStyle{}, palette, estimated_text_width), palette));
}

}  // namespace myo::chart
