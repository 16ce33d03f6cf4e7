#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "report/chart.hpp"
#include "report/palette.hpp"
#include "report/ticks.hpp"

namespace myo::report {

/// The parts that all figures share: document, text, axes, legend. Coordinates in pixels, y down.

struct Rectangle {
    double left = 0.0;
    double top = 0.0;
    double width = 0.0;
    double height = 0.0;
    double right() const { return left + width; }
    double bottom() const { return top + height; }
};

/// Maps a value of an axis to pixels. Not finite where the value cannot be drawn.
struct Scale {
    double lowest = 0.0;
    double highest = 1.0;
    double from_px = 0.0;  // pixel of `lowest`
    double to_px = 1.0;
    bool logarithmic = false;
    double operator()(double value) const;
};

struct PlannedAxis {
    Ticks ticks;
    Scale scale;
};

/// Smallest and largest finite value seen (positive ones on a logarithmic axis).
struct DataRange {
    explicit DataRange(const Axis& axis) : logarithmic(axis.logarithmic) {}
    bool logarithmic;
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -std::numeric_limits<double>::infinity();
    void add(double value);
};

/// Range (given, or the data's with `padding` of its size on both sides), ticks and scale.
PlannedAxis plan_axis(const Axis& axis, const DataRange& data, double padding, double from_px, double to_px);

/// "label [10⁻³ m]"
std::string axis_title(const Axis& axis, const Ticks& ticks);

std::string open_svg(double width, double height, const std::string& title);

enum class Anchor { start, middle, end };
struct TextStyle {
    double size = 11.0;
    Anchor anchor = Anchor::start;
    std::string_view colour = ink::quiet;
    bool bold = false;
    bool halo = false;  // white rim, for text over curves
};
std::string svg_text(double x, double y, std::string_view text, const TextStyle& style = {});
std::string svg_line(double x1, double y1, double x2, double y2, std::string_view colour, double width,
                     std::string_view dash = {});
std::string svg_box(const Rectangle& box, std::string_view colour, double radius = 0.0, double opacity = 1.0);

/// Estimated width of text in the system font.
double text_width(std::string_view text, double size = 11.0);

/// Room for the labels left of a vertical axis.
double label_room(const Ticks& ticks);

/// Grid lines, labels and title (above the top left corner) of a vertical axis.
std::string draw_vertical_axis(const Axis& axis, const PlannedAxis& plan, const Rectangle& area);

/// Tick marks of a horizontal axis; labels and title below only when `with_labels`.
std::string draw_horizontal_axis(const Axis& axis, const PlannedAxis& plan, const Rectangle& area, bool with_labels);
inline constexpr double horizontal_axis_height = 40.0;

/// Thin lines at values of a horizontal scale, over the height of the area, their words at its top.
std::string draw_vertical_references(const std::vector<ReferenceLine>& lines, const Scale& scale,
                                     const Rectangle& area);

/// How a legend entry shows its series.
struct LegendEntry {
    std::string name;
    std::string sign;  // SVG drawn around (0, 0), 22 px wide
};

/// Lines of entries that start at (left, top) and wrap at `width`; `height` gets what they take.
std::string draw_legend(const std::vector<LegendEntry>& entries, double left, double top, double width, double& height);

/// Colour text of a slot; slots beyond the palette start again.
std::string_view slot_colour(int slot);

/// Title line and the height that it takes (0 when empty).
std::string draw_title(const std::string& title, double left, double& height);

}  // namespace myo::report
