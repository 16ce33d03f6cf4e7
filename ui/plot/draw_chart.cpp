#include "plot/draw_chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace myo::ui::plot {
namespace {

/// Colour as draw lists take it.
ImU32 packed_colour(const chart::Colour& colour) { return platform::packed(window_colour(colour)); }

/// A place of a chart in the window: both count in the window's pixels.
ImVec2 window_point(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

/// Draws marks one after another.
struct MarkPainter {
    ImDrawList& list;
    const platform::Theme& theme;

    void operator()(const chart::Box& box) const {
        const chart::Rectangle& a = box.area;
        list.AddRectFilled(window_point(a.left, a.top), window_point(a.right(), a.bottom()), packed_colour(box.colour),
                           static_cast<float>(box.radius));
    }

    void operator()(const chart::Stroke& stroke) const {
        const chart::Polyline& curve = stroke.points;
        ImVec2 start{};  // of the next piece
        bool joined = false;
        double along = 0.0;  // length of the curve so far, for the dashes
        for (std::size_t i = 1; i < curve.x.size(); ++i) {
            if (!curve.has_point(i) || !curve.has_point(i - 1)) {
                joined = false;
                continue;
            }
            const bool continues = joined;
            joined = true;
            if (!continues) start = window_point(curve.x[i - 1], curve.y[i - 1]);
            ImVec2 from = start, to = window_point(curve.x[i], curve.y[i]);
            // Steps far below a pixel are joined, as traces may hold many samples per pixel.
            const bool ends = i + 1 == curve.x.size() || !curve.has_point(i + 1);
            if (!ends && std::abs(from.x - to.x) < 0.3f && std::abs(from.y - to.y) < 0.3f) continue;
            start = to;
            // Straight lines along the axes lie on pixels, or they would be blurred.
            if (curve.x.size() == 2 && from.x == to.x) from.x = to.x = std::round(from.x);
            if (curve.x.size() == 2 && from.y == to.y) from.y = to.y = std::round(from.y);
            segment(stroke, from, to, along);
        }
    }

    void operator()(const chart::Band& band) const {
        // Smoothed edges would leave seams between neighbouring pieces.
        const ImDrawListFlags flags = list.Flags;
        list.Flags &= ~ImDrawListFlags_AntiAliasedFill;
        for (std::size_t i = 1; i < band.x.size(); ++i)
            if (std::isfinite(band.x[i] + band.upper[i] + band.lower[i]) &&
                std::isfinite(band.x[i - 1] + band.upper[i - 1] + band.lower[i - 1]))
                list.AddQuadFilled(window_point(band.x[i - 1], band.upper[i - 1]),
                                   window_point(band.x[i], band.upper[i]), window_point(band.x[i], band.lower[i]),
                                   window_point(band.x[i - 1], band.lower[i - 1]), packed_colour(band.colour));
        list.Flags = flags;
    }

    void operator()(const chart::Dots& dots) const {
        // Dots within one pixel are drawn once, as traces may hold many samples per pixel.
        ImVec2 last{-1e9f, -1e9f};
        for (std::size_t i = 0; i < dots.centres.x.size(); ++i) {
            if (!dots.centres.has_point(i)) continue;
            const ImVec2 p = window_point(dots.centres.x[i], dots.centres.y[i]);
            if (std::abs(p.x - last.x) + std::abs(p.y - last.y) <= 0.7f) continue;
            list.AddCircleFilled(p, static_cast<float>(0.5 * dots.diameter), packed_colour(dots.colour), 8);
            last = p;
        }
    }

    void operator()(const chart::Polygon& polygon) const {
        std::vector<ImVec2> corners;
        for (std::size_t i = 0; i < polygon.corners.x.size(); ++i)
            corners.push_back(window_point(polygon.corners.x[i], polygon.corners.y[i]));
        const int count = static_cast<int>(corners.size());
        list.AddConvexPolyFilled(corners.data(), count, packed_colour(polygon.fill));
        list.AddPolyline(corners.data(), count, packed_colour(polygon.edge), ImDrawFlags_Closed,
                         static_cast<float>(polygon.width));
    }

    void operator()(const chart::Text& text) const {
        if (text.text.empty()) return;
        ImFont* font = text.bold ? theme.strong : theme.small;
        const auto size = static_cast<float>(text.size);
        const ImVec2 extent = font->CalcTextSizeA(size, 1e6f, 0.0f, text.text.c_str());
        const float share = text.anchor == chart::Anchor::start    ? 0.0f
                            : text.anchor == chart::Anchor::middle ? 0.5f
                                                                   : 1.0f;
        const ImVec2 at = window_point(text.at.x, text.at.y);
        // On whole pixels, or the letters would be blurred.
        const ImVec2 corner{std::round(at.x - share * extent.x), std::round(at.y - 0.5f * size)};
        const int first = list.VtxBuffer.Size;
        if (text.halo)
            // A copy in each diagonal direction is an outline of one pixel.
            for (const ImVec2& by : {ImVec2{-1, -1}, ImVec2{1, -1}, ImVec2{-1, 1}, ImVec2{1, 1}})
                list.AddText(font, size, {corner.x + by.x, corner.y + by.y}, packed_colour(*text.halo),
                             text.text.c_str());
        list.AddText(font, size, corner, packed_colour(text.colour), text.text.c_str());
        if (text.turned != 0.0) turn(first, at, text.turned);
    }

    void operator()(const chart::Clip& clip) const {
        if (!clip.area) return list.PopClipRect();
        list.PushClipRect(window_point(clip.area->left, clip.area->top),
                          window_point(clip.area->right(), clip.area->bottom()), true);
    }

private:
    /// One piece of a stroke with its dashes. `along` is the length of the curve before it, and is advanced.
    void segment(const chart::Stroke& stroke, const ImVec2& from, const ImVec2& to, double& along) const {
        const ImU32 colour = packed_colour(stroke.colour);
        const auto width = static_cast<float>(stroke.width);
        const double length = std::hypot(static_cast<double>(to.x - from.x), static_cast<double>(to.y - from.y));
        const double period = stroke.dash + stroke.gap;
        if (!(stroke.dash > 0.0) || !(period > 0.0)) return list.AddLine(from, to, colour, width);
        const auto point = [&](double s) {
            const auto part = static_cast<float>(s / std::max(length, 1e-9));
            return ImVec2{from.x + part * (to.x - from.x), from.y + part * (to.y - from.y)};
        };
        // Far outside of the view there is nothing to see; a limit keeps the number of dashes small.
        for (double s = -std::fmod(along, period), n = 0.0; s < length && n < 4000.0; s += period, n += 1.0)
            if (s + stroke.dash > 0.0)
                list.AddLine(point(std::max(0.0, s)), point(std::min(length, s + stroke.dash)), colour, width);
        along += length;
    }

    /// Rotates the vertices from `first` on about a centre, clockwise [degrees].
    void turn(int first, const ImVec2& centre, double degrees) const {
        const auto angle = static_cast<float>(degrees * 3.14159265358979 / 180.0);
        const float c = std::cos(angle), s = std::sin(angle);
        for (int i = first; i < list.VtxBuffer.Size; ++i) {
            ImVec2& p = list.VtxBuffer[i].pos;
            const ImVec2 d{p.x - centre.x, p.y - centre.y};
            p = {centre.x + c * d.x - s * d.y, centre.y + s * d.x + c * d.y};
        }
    }
};

}  // namespace

chart::Colour chart_colour(const ImVec4& color) {
    const auto byte = [](float part) {
        return static_cast<std::uint32_t>(std::lround(255.0f * std::clamp(part, 0.0f, 1.0f)));
    };
    return {byte(color.x) << 16 | byte(color.y) << 8 | byte(color.z), static_cast<double>(color.w)};
}

ImVec4 window_colour(const chart::Colour& colour) {
    const auto part = [&](int shift) { return static_cast<float>((colour.rgb >> shift) & 255u) / 255.0f; };
    return {part(16), part(8), part(0), static_cast<float>(colour.opacity)};
}

chart::Palette chart_palette(const platform::Theme& theme) {
    chart::Palette palette;
    palette.paper = chart_colour(theme.panel);
    palette.plot = chart_colour(theme.plot);
    palette.text = chart_colour(theme.text);
    palette.quiet = palette.legend = chart_colour(theme.muted);
    palette.axis = chart::faded(palette.quiet, 0.6);
    palette.grid = chart_colour(theme.border);
    palette.shade = chart::faded(chart_colour(theme.accent), 0.14);
    for (const ImVec4& color : theme.muscles) palette.series.push_back(chart_colour(color));
    return palette;
}

chart::LayoutStyle window_style(const platform::Theme& theme) {
    return chart::compact_style(static_cast<double>(theme.small->FontSize), static_cast<double>(theme.scale));
}

chart::TextWidth window_text_width(const platform::Theme& theme) {
    return [font = theme.small](std::string_view text, double size) {
        return static_cast<double>(
            font->CalcTextSizeA(static_cast<float>(size), 1e6f, 0.0f, text.data(), text.data() + text.size()).x);
    };
}

void draw_chart(ImDrawList& list, const chart::Drawing& drawing, const platform::Theme& theme) {
    const MarkPainter painter{list, theme};
    for (const chart::Mark& mark : drawing.marks) std::visit(painter, mark);
}

}  // namespace myo::ui::plot
