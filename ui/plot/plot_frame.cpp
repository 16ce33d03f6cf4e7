#include "plot/plot_frame.hpp"

#include <algorithm>
#include <cmath>

#include "plot/legend.hpp"

namespace myo::ui::plot {
namespace {

/// Pixel of a data coordinate in the window. The second one swaps the ends of the area, as pixels grow downwards.
float px(const PlotArea& area, double x) {
    return static_cast<float>(
        to_pixel(area.x, x, static_cast<double>(area.pixels.lowest.x), static_cast<double>(area.pixels.highest.x)));
}

float py(const PlotArea& area, double y) {
    return static_cast<float>(
        to_pixel(area.y, y, static_cast<double>(area.pixels.highest.y), static_cast<double>(area.pixels.lowest.y)));
}

void text(ImDrawList& list, ImFont* font, const ImVec2& at, ImU32 color, const std::string& what) {
    list.AddText(font, font->FontSize, at, color, what.c_str());
}

ImVec2 extent(ImFont* font, const std::string& what) {
    return font->CalcTextSizeA(font->FontSize, 1e6f, 0.0f, what.c_str());
}

}  // namespace

Eigen::Index nearest_sample(const Eigen::VectorXd& x, double value) {
    if (x.size() == 0) return -1;
    const double* first = x.data();
    // The first sample not below `value`; the nearest one is this or the one before.
    const double* last = first + x.size();
    const double* above = std::lower_bound(first, last, value);
    if (above == last) return x.size() - 1;
    if (above != first && value - above[-1] < *above - value) --above;
    return above - first;
}

void draw_plot_frame(ImDrawList& list, const Plot& plot, const PlotArea& area, const platform::Theme& theme) {
    const platform::Rectangle& r = area.pixels;
    list.AddRectFilled(r.lowest, r.highest, platform::packed(theme.plot));
    ImFont* font = theme.small;
    const ImU32 line = platform::packed(theme.border);
    const ImU32 muted = platform::packed(theme.muted);
    // One tick per 64 pixels at most: labels with their unit are about this wide.
    const Ticks x_ticks = make_ticks(area.x, std::max(2, static_cast<int>(r.width() / (64.0f * theme.scale))));
    for (const double v : x_ticks.values) {
        const float x = std::round(px(area, v));
        list.AddLine({x, r.lowest.y}, {x, r.highest.y}, line);
        if (!plot.x_axis) continue;
        const std::string label = tick_label(v, x_ticks.step) + " " + plot.x_unit;
        const float width = extent(font, label).x;
        // Labels at both ends stay inside the area, so that those of neighbouring plots do not touch.
        const float left = std::clamp(x - 0.5f * width, r.lowest.x, r.highest.x - width);
        text(list, font, {left, r.highest.y + 2.0f * theme.scale}, muted, label);
    }
    const Ticks y_ticks = make_ticks(area.y, std::max(5, static_cast<int>(r.height() / (18.0f * theme.scale))));
    // In a low plot only every second or fifth grid line has room for its label. Multiples are counted from zero, so
    // that zero keeps its label.
    const double step_pixels = y_ticks.step / area.y.span() * static_cast<double>(r.height());
    const double needed = static_cast<double>(font->FontSize);
    const long every = step_pixels >= needed ? 1 : 2.0 * step_pixels >= needed ? 2 : 5;
    const auto regular = [&](double v) { return std::lround(v / y_ticks.step) % every == 0; };
    const auto ends = [&](double v) { return v == y_ticks.values.front() || v == y_ticks.values.back(); };
    // A single number gives no scale. In that case the outermost lines are labelled instead.
    const bool enough = std::count_if(y_ticks.values.begin(), y_ticks.values.end(), regular) > 1;
    for (const double v : y_ticks.values) {
        const float y = std::round(py(area, v));
        list.AddLine({r.lowest.x, y}, {r.highest.x, y}, line);
        if (enough ? !regular(v) : !ends(v)) continue;
        const std::string label = tick_label(v, y_ticks.step);
        const ImVec2 size = extent(font, label);
        const float top = std::clamp(y - 0.5f * size.y, r.lowest.y - 3.0f * theme.scale,
                                     r.highest.y - size.y + 3.0f * theme.scale);
        text(list, font, {r.lowest.x - size.x - 6.0f * theme.scale, top}, muted, label);
    }
    if (plot.zero_line && area.y.lowest < 0.0 && area.y.highest > 0.0) {
        const float y = std::round(py(area, 0.0));
        list.AddLine({r.lowest.x, y}, {r.highest.x, y}, platform::packed(theme.muted, 0.6f));
    }
}

void draw_plot_series(ImDrawList& list, const PlotSeries& series, const PlotArea& area, const platform::Theme& theme) {
    const ImU32 color = platform::packed(series.color);
    const float radius = 1.7f * theme.scale;
    const Eigen::Index count = std::min(series.x.size(), series.y.size());
    ImVec2 last{};
    bool open = false;
    for (Eigen::Index i = 0; i < count; ++i) {
        if (!std::isfinite(series.y[i]) || !std::isfinite(series.x[i])) {
            open = false;
            continue;
        }
        const ImVec2 p{px(area, series.x[i]), py(area, series.y[i])};
        const bool outside = p.x < area.pixels.lowest.x - 50.0f || p.x > area.pixels.highest.x + 50.0f;
        // Points within one pixel are drawn once, as traces may hold many samples per pixel.
        if (series.dots) {
            if (!outside && (!open || std::abs(p.x - last.x) + std::abs(p.y - last.y) > 0.7f)) {
                list.AddCircleFilled(p, radius, color, 8);
                last = p;
                open = true;
            }
            continue;
        }
        if (open && std::abs(p.x - last.x) < 0.3f && std::abs(p.y - last.y) < 0.3f && i + 1 < count) continue;
        // Segments that lie outside on one side are skipped; those that cross the area are clipped by ImGui.
        const bool both_left = open && p.x < area.pixels.lowest.x && last.x < area.pixels.lowest.x;
        const bool both_right = open && p.x > area.pixels.highest.x && last.x > area.pixels.highest.x;
        if (open && !both_left && !both_right) list.AddLine(last, p, color, 1.6f * theme.scale);
        last = p;
        open = true;
    }
}

void draw_plot_legend(ImDrawList& list, const Plot& plot, const PlotArea& area, const platform::Theme& theme,
                      platform::ItemRectangles& items, HiddenSeries& hidden) {
    const float row = theme.small->FontSize + 6.0f * theme.scale;
    // From right to left, until the area is full: the first curves lose their entry if there is no room for all.
    float right = area.pixels.highest.x;
    for (std::size_t i = plot.series.size(); i-- > 0;) {
        const PlotSeries& series = plot.series[i];
        const LegendEntry entry{series.name, series.color, series.dots};
        const float left = right - legend_width(entry, theme);
        if (left < area.pixels.lowest.x) break;
        // The click area of an entry is as high as the line of the title.
        const platform::Rectangle box{{left, area.pixels.lowest.y - row}, {right, area.pixels.lowest.y}};
        right = left - 10.0f * theme.scale;
        items.add(plot.id + "/legend/" + series.name, box);
        const bool hovered = ImGui::IsWindowHovered() && box.contains(ImGui::GetIO().MousePos);
        draw_legend_entry(list, entry, box, hovered, hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left), theme,
                          hidden);
    }
}

void draw_plot_crosshair(ImDrawList& list, const Plot& plot, const PlotArea& area, const platform::Theme& theme,
                         const HiddenSeries& hidden) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const platform::Rectangle& r = area.pixels;
    list.AddLine({std::round(mouse.x), r.lowest.y}, {std::round(mouse.x), r.highest.y},
                 platform::packed(theme.muted, 0.5f));
    list.AddLine({r.lowest.x, std::round(mouse.y)}, {r.highest.x, std::round(mouse.y)},
                 platform::packed(theme.muted, 0.5f));
    const double x = from_pixel(area.x, static_cast<double>(mouse.x), static_cast<double>(r.lowest.x),
                                static_cast<double>(r.highest.x));
    ImGui::BeginTooltip();
    ImGui::PushFont(theme.small);
    // Hidden curves are left out of the tooltip, too.
    ImGui::Text("%s %s", value_label(x, 4).c_str(), plot.x_unit.c_str());
    for (const PlotSeries& series : plot.series) {
        if (hidden.count(series.name) > 0) continue;
        const Eigen::Index i = nearest_sample(series.x, x);
        if (i < 0 || i >= series.y.size()) continue;
        ImGui::TextColored(series.color, "%s  %s %s", series.name.c_str(), value_label(series.y[i], 4).c_str(),
                           plot.y_unit.c_str());
    }
    ImGui::PopFont();
    ImGui::EndTooltip();
}

}  // namespace myo::ui::plot
