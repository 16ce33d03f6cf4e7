#include "viewport/view_overlay.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

#include "chart/scale.hpp"
#include "plot/number_text.hpp"
#include "viewport/color_map.hpp"

namespace myo::ui::viewport {
namespace {

/// The view's size in whole pixels, as the camera takes it.
ViewSize size_of(const platform::Rectangle& view) {
    return {static_cast<int>(view.width()), static_cast<int>(view.height())};
}

// Small text with a thin outline, so that it is legible over any image.
void outlined(ImDrawList& list, const platform::Theme& theme, const ImVec2& at, ImU32 color, ImU32 halo,
              const char* text) {
    ImFont* const font = theme.small;
    const float d = std::max(1.0f, std::round(theme.scale));
    for (const ImVec2 side : {ImVec2(-d, 0), ImVec2(d, 0), ImVec2(0, -d), ImVec2(0, d)}) {
        list.AddText(font, font->FontSize, {at.x + side.x, at.y + side.y}, halo, text);
    }
    list.AddText(font, font->FontSize, at, color, text);
}

/// A length or force with an SI prefix: "20 mm", "5 µN". The tolerances keep 1.0 from being printed as 1000 m.
std::string with_unit(double value, const std::string& unit) {
    if (value >= 1.0 - 1e-9) return plot::value_label(value, 1) + " " + unit;
    if (value >= 1e-3 * (1.0 - 1e-9)) return plot::value_label(value * 1e3, 1) + " m" + unit;
    return plot::value_label(value * 1e6, 1) + " \xc2\xb5" + unit;
}

// The bar ends at `end`; its label is centred above it as far as the margin of the view allows.
void draw_bar_with_label(ImDrawList& list, const ImVec2& end, const ScaleBar& bar, ImU32 color,
                         const platform::Theme& theme) {
    const float s = theme.scale;
    const float left = end.x - static_cast<float>(bar.pixels);
    list.AddLine({left, end.y}, end, color, 2.0f * s);
    for (const float x : {left, end.x}) list.AddLine({x, end.y - 5.0f * s}, {x, end.y + s}, color, 2.0f * s);
    const float width = theme.small->CalcTextSizeA(theme.small->FontSize, 1e6f, 0.0f, bar.label.c_str()).x;
    // centred, or flush right if the label is longer than the bar
    const float from = std::min(0.5f * (left + end.x - width),
                                end.x - width);  // centred, or flush right where it is longer
    outlined(list, theme, {from, end.y - theme.small->FontSize - 6.0f * s}, color,
             platform::packed(theme.view_bottom, 0.6f), bar.label.c_str());
}

/// Finds a place for a label next to a point where it covers no other label. Tries right and left of the point, at its
/// height, below and above. Returns empty if none is free.
std::optional<platform::Rectangle> room_beside(const ImVec2& p, const ImVec2& extent, float gap,
                                               const platform::Rectangle& view,
                                               const std::vector<platform::Rectangle>& taken) {
    for (const float line : {0.0f, 1.0f, -1.0f, 2.0f})
        for (const float left : {p.x + gap, p.x - gap - extent.x}) {
            const float top = p.y + (line - 0.5f) * extent.y;
            const platform::Rectangle box{{left, top}, {left + extent.x, top + extent.y}};
            const auto overlaps = [&](const platform::Rectangle& other) {
                return box.lowest.x < other.highest.x && other.lowest.x < box.highest.x &&
                       box.lowest.y < other.highest.y && other.lowest.y < box.highest.y;
            };
            if (view.contains(box.lowest) && view.contains(box.highest) &&
                std::none_of(taken.begin(), taken.end(), overlaps))
                return box;
        }
    return std::nullopt;
}

/// Scale bar for lengths at the distance of the target, in the lower right corner.
void draw_scale_bar(ImDrawList& list, const platform::Rectangle& view, const Camera& camera,
                    const platform::Theme& theme) {
    const float s = theme.scale;
    const ScaleBar bar = make_scale_bar(metres_per_pixel(camera, size_of(view)), 120.0 * static_cast<double>(s), "m");
    draw_bar_with_label(list, {view.highest.x - 16.0f * s, view.highest.y - 16.0f * s}, bar,
                        platform::packed(theme.text), theme);
}

/// Scale bar for force arrows, above the one for lengths, with the name of the force.
void draw_arrow_scale(ImDrawList& list, const platform::Rectangle& view, const Camera& camera, const ArrowScale& arrows,
                      const platform::Theme& theme) {
    const float s = theme.scale;
    const ScaleBar bar = make_scale_bar(metres_per_pixel(camera, size_of(view)) / arrows.metres_per_N,
                                        120.0 * static_cast<double>(s), "N");
    const ImU32 color = platform::packed({arrows.color[0], arrows.color[1], arrows.color[2], 1.0f});
    draw_bar_with_label(list, {view.highest.x - 16.0f * s, view.highest.y - 56.0f * s}, bar, color, theme);
    const auto width_of = [&](const std::string& text) {
        return theme.small->CalcTextSizeA(theme.small->FontSize, 1e6f, 0.0f, text.c_str()).x;
    };
    // The long title is used only if it leaves most of the view free.
    const std::string whole = arrows.name + " on each part of the body";
    const std::string& title = width_of(whole) < 0.4f * view.width() ? whole : arrows.name;
    const float width = width_of(title);
    outlined(list, theme,
             {view.highest.x - 16.0f * s - width, view.highest.y - 64.0f * s - 2.0f * theme.small->FontSize}, color,
             platform::packed(theme.view_bottom, 0.6f), title.c_str());
}

/// Letter of an axis beyond its tip. An axis that points at the eye has no room for it.
void draw_axis_letter(ImDrawList& list, const platform::Theme& theme, const ImVec2& tip, const ImVec2& direction,
                      const ImVec4& color, const char* name) {
    const float s = theme.scale, x = direction.x, y = direction.y;
    const float length = std::hypot(x, y);
    const float out = length > 0.2f ? 10.0f * s / length : 0.0f;
    const ImVec2 center{tip.x + out * x, tip.y + out * y};
    const ImVec2 extent = theme.small->CalcTextSizeA(theme.small->FontSize, 1e6f, 0.0f, name);
    if (length > 0.2f) {
        outlined(list, theme, {center.x - 0.5f * extent.x, center.y - 0.5f * extent.y}, platform::packed(color),
                 platform::packed(theme.view_bottom, 0.6f), name);
    }
}

/// Axes of the world frame in the lower left corner.
void draw_axes(ImDrawList& list, const platform::Rectangle& view, const Camera& camera, const platform::Theme& theme) {
    const float s = theme.scale;
    const ImVec2 origin{view.lowest.x + 44.0f * s, view.highest.y - 44.0f * s};
    const CameraAxes axes = camera_axes(camera);
    struct Axis {
        Eigen::Vector3d direction;
        ImVec4 color;
        const char* name;
    };
    std::vector<Axis> all{{Eigen::Vector3d::UnitX(), theme.axis_x, "x"},
                          {Eigen::Vector3d::UnitY(), theme.axis_y, "y"},
                          {Eigen::Vector3d::UnitZ(), theme.axis_z, "z"}};
    // Axes that point away are drawn first, so that the one towards the eye covers them.
    std::sort(all.begin(), all.end(),
              [&](const Axis& a, const Axis& b) { return a.direction.dot(axes.back) < b.direction.dot(axes.back); });
    for (const Axis& axis : all) {
        const float x = static_cast<float>(axis.direction.dot(axes.right));
        const float y = static_cast<float>(-axis.direction.dot(axes.up));
        const ImVec2 tip{origin.x + 26.0f * s * x, origin.y + 26.0f * s * y};
        list.AddLine(origin, tip, platform::packed(axis.color), 2.0f * s);
        draw_axis_letter(list, theme, tip, {x, y}, axis.color, axis.name);
    }
}

/// Names of the markers. Each label takes the first free place; markers without one stay unnamed.
void draw_marker_labels(ImDrawList& list, const platform::Rectangle& view, const Camera& camera,
                        const DrawnScene& scene, const platform::Theme& theme) {
    const float s = theme.scale;
    // The corners with scale bars, axes and legend are reserved.
    const float corner = (scene.arrows ? 96.0f : 40.0f) * s + theme.small->FontSize;
    std::vector<platform::Rectangle> taken{
        {{view.highest.x - 150.0f * s, view.highest.y - corner}, view.highest},
        {{view.lowest.x, view.highest.y - 88.0f * s}, {view.lowest.x + 88.0f * s, view.highest.y}}};
    if (!scene.legend.empty()) {
        const float height = static_cast<float>(scene.legend.size()) * (theme.small->FontSize + 6.0f * s);
        taken.push_back(
            {{view.highest.x - 180.0f * s, view.lowest.y}, {view.highest.x, view.lowest.y + 16.0f * s + height}});
    }
    if (scene.field)
        taken.push_back({{view.highest.x - 80.0f * s, view.lowest.y}, {view.highest.x, view.lowest.y + 210.0f * s}});
    for (const DrawnMarker& marker : scene.markers) {
        if (marker.label.empty() || !marker.position.allFinite()) continue;
        const auto place = project(camera, size_of(view), marker.position);
        if (!place) continue;
        const ImVec2 p{view.lowest.x + static_cast<float>(place->x()), view.lowest.y + static_cast<float>(place->y())};
        if (!view.contains(p)) continue;
        const ImVec2 extent = theme.small->CalcTextSizeA(theme.small->FontSize, 1e6f, 0.0f, marker.label.c_str());
        const std::optional<platform::Rectangle> box = room_beside(p, extent, 16.0f * s, view, taken);
        if (!box) continue;  // a click on the marker shows its name
        taken.push_back(*box);
        outlined(list, theme, box->lowest, platform::packed(theme.text), platform::packed(theme.view_bottom, 0.8f),
                 marker.label.c_str());
    }
}

/// Texts of loads, gravity and parts, right of their points.
void draw_labels(ImDrawList& list, const platform::Rectangle& view, const Camera& camera, const DrawnScene& scene,
                 const platform::Theme& theme) {
    const float gap = 6.0f * theme.scale;
    for (const DrawnLabel& label : scene.labels) {
        const auto place = project(camera, size_of(view), label.position);
        if (!place) continue;
        const ImVec2 p{view.lowest.x + static_cast<float>(place->x()), view.lowest.y + static_cast<float>(place->y())};
        if (!view.contains(p)) continue;
        outlined(list, theme, {p.x + gap, p.y - 0.5f * theme.small->FontSize},
                 platform::packed({label.color[0], label.color[1], label.color[2], label.color[3]}),
                 platform::packed(theme.view_bottom, 0.8f), label.text.c_str());
    }
}

/// Colours of the field from `corner` to the right edge, the highest value at the top.
void draw_color_bar(ImDrawList& list, const DrawnField& field, const ImVec2& corner, float right, float height) {
    const float left = corner.x, top = corner.y;
    // Rectangles instead of a texture: 64 of them look continuous at this size.
    constexpr int steps = 64;
    for (int i = 0; i < steps; ++i) {
        const double level = 1.0 - (i + 0.5) / steps;
        const Eigen::Vector3f c = field.diverging
                                      ? diverging_color_map(level)
                                      : color_maps()[static_cast<std::size_t>(field.color_map)].color(level);
        const float y0 = top + height * static_cast<float>(i) / steps;
        const float y1 = top + height * static_cast<float>(i + 1) / steps;
        list.AddRectFilled({left, y0}, {right, y1}, platform::packed({c[0], c[1], c[2], 1.0f}));
    }
}

/// Values of the legend, left of the colours, which begin at `left`.
void draw_legend_ticks(ImDrawList& list, const chart::PlannedAxis& plan, const platform::Theme& theme, float left,
                       ImU32 halo) {
    const float s = theme.scale;
    for (std::size_t i = 0; i < plan.ticks.values.size(); ++i) {
        const auto y = static_cast<float>(plan.scale(plan.ticks.values[i]));
        const std::string& label = plan.ticks.labels[i];
        const ImVec2 extent = theme.small->CalcTextSizeA(theme.small->FontSize, 1e6f, 0.0f, label.c_str());
        list.AddLine({left - 4.0f * s, y}, {left, y}, platform::packed(theme.muted), s);
        outlined(list, theme, {left - 8.0f * s - extent.x, y - 0.5f * extent.y}, platform::packed(theme.text), halo,
                 label.c_str());
    }
}

/// Colour bar with ticks in the upper right corner. Left out if the view is too low for it.
void draw_field_legend(ImDrawList& list, const platform::Rectangle& view, const DrawnField& field,
                       const platform::Theme& theme) {
    const float s = theme.scale;
    const float height = std::min(160.0f * s, view.height() - 150.0f * s);
    if (height < 40.0f) return;
    // The axis of a chart gives ticks and title: a power of ten that the labels share belongs to the unit.
    const chart::Axis axis{.label = field.name, .unit = field.unit, .lowest = field.lowest, .highest = field.highest};
    const double at_top = static_cast<double>(view.lowest.y + 40.0f * s);
    const chart::PlannedAxis plan = chart::plan_axis(
        axis, chart::DataRange(axis), 0.0, at_top + static_cast<double>(height), at_top, 28.0 * static_cast<double>(s));
    const std::string title = chart::axis_title(axis, plan.ticks);
    const float title_width = theme.small->CalcTextSizeA(theme.small->FontSize, 1e6f, 0.0f, title.c_str()).x;
    const float right = view.highest.x - 16.0f * s;
    const float top = view.lowest.y + 40.0f * s;
    const ImU32 halo = platform::packed(theme.view_top, 0.8f);
    outlined(list, theme, {right - title_width, top - theme.small->FontSize - 8.0f * s}, platform::packed(theme.text),
             halo, title.c_str());
    const float left = right - 14.0f * s;
    draw_color_bar(list, field, {left, top}, right, height);
    list.AddRect({left, top}, {right, top + height}, platform::packed(theme.muted), 0.0f, 0, s);
    draw_legend_ticks(list, plan, theme, left, halo);
}

/// Materials of the body in the upper right corner: a square in the colour of each, and its text left of it.
void draw_part_legend(ImDrawList& list, const platform::Rectangle& view, const DrawnScene& scene,
                      const platform::Theme& theme) {
    const float s = theme.scale, size = theme.small->FontSize, line = size + 6.0f * s;
    const float right = view.highest.x - 16.0f * s;
    float top = view.lowest.y + 16.0f * s;
    for (const DrawnLegendEntry& entry : scene.legend) {
        // A low view has room for the first materials only.
        if (top + line > view.highest.y - 80.0f * s) return;
        const ImU32 color = platform::packed({entry.color[0], entry.color[1], entry.color[2], 1.0f});
        list.AddRectFilled({right - size, top}, {right, top + size}, color, 3.0f * s);
        const float width = theme.small->CalcTextSizeA(size, 1e6f, 0.0f, entry.text.c_str()).x;
        outlined(list, theme, {right - size - 8.0f * s - width, top}, platform::packed(theme.text),
                 platform::packed(theme.view_top, 0.8f), entry.text.c_str());
        top += line;
    }
}

}  // namespace

ScaleBar make_scale_bar(double per_pixel, double longest, const std::string& unit) {
    ScaleBar bar;
    bar.length = chart::round_step(per_pixel * longest);
    // round_step() rounds up, so the bar may be too long. The next smaller round step fits.
    if (bar.length > per_pixel * longest) bar.length = chart::round_step(bar.length / 2.6);
    bar.pixels = bar.length / per_pixel;
    bar.label = with_unit(bar.length, unit);
    return bar;
}

void draw_view_overlay(ImDrawList& list, const platform::Rectangle& view, const Camera& camera, const DrawnScene& scene,
                       const platform::Theme& theme, bool names) {
    if (names) draw_marker_labels(list, view, camera, scene, theme);
    draw_labels(list, view, camera, scene, theme);
    draw_axes(list, view, camera, theme);
    draw_scale_bar(list, view, camera, theme);
    if (scene.arrows) draw_arrow_scale(list, view, camera, *scene.arrows, theme);
    if (scene.field) draw_field_legend(list, view, *scene.field, theme);
    draw_part_legend(list, view, scene, theme);
}

void draw_view_title(ImDrawList& list, const platform::Rectangle& view, const std::string& title,
                     const platform::Theme& theme) {
    const float margin = 16.0f * theme.scale;
    outlined(list, theme, {view.lowest.x + margin, view.lowest.y + margin}, platform::packed(theme.text),
             platform::packed(theme.view_top, 0.8f), title.c_str());
}

}  // namespace myo::ui::viewport
