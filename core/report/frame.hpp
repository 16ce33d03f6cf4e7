#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "report/chart.hpp"
#include "report/palette.hpp"
#include "report/ticks.hpp"

namespace myo::report {

/// Parts shared by all figures: document, text, axes, legend. Coordinates in pixels, y downwards.

/// Rectangle in pixels.
struct Rectangle {
    double left = 0.0;
    double top = 0.0;
    double width = 0.0;
    double height = 0.0;
    /// Pixel of the right edge.
    double right() const { return left + width; }
    /// Pixel of the lower edge; y points downwards.
    double bottom() const { return top + height; }
};

/// Maps values of an axis to pixels. The result is not finite if the value cannot be drawn.
struct Scale {
    double lowest = 0.0;
    double highest = 1.0;
    double from_px = 0.0;  // pixel of `lowest`
    double to_px = 1.0;    // pixel of `highest`
    bool logarithmic = false;
    /// Pixel of a value, not clipped to the axis.
    double operator()(double value) const;
};

/// Ticks and scale of an axis.
struct PlannedAxis {
    Ticks ticks;
    Scale scale;
};

/// Smallest and largest finite value added (positive values only for a logarithmic axis).
struct DataRange {
    explicit DataRange(const Axis& axis) : logarithmic(axis.logarithmic) {}
    bool logarithmic;
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -std::numeric_limits<double>::infinity();
    /// Extends the range by a value; values that cannot be drawn are ignored.
    void add(double value);
};

/// Range, ticks and scale of an axis.
///
/// @param padding         fraction of the data range added on both sides, unless the range is given
/// @param from_px, to_px  pixels of the ends; from_px > to_px for a vertical axis
PlannedAxis plan_axis(const Axis& axis, const DataRange& data, double padding, double from_px, double to_px);

/// Axis title with factor and unit, e.g. "label [10⁻³ m]".
std::string axis_title(const Axis& axis, const Ticks& ticks);

/// Start of an SVG document with white background; the caller appends "</svg>".
std::string open_svg(double width, double height, const std::string& title);

/// Horizontal alignment of text relative to its position.
enum class Anchor { start, middle, end };
/// Style of a text element.
struct TextStyle {
    double size = 11.0;  // font size [px]
    Anchor anchor = Anchor::start;
    std::string_view colour = ink::quiet;
    bool bold = false;
    bool halo = false;  // white outline, for text over curves
};
/// Text element; empty for empty text.
std::string svg_text(double x, double y, std::string_view text, const TextStyle& style = {});
/// Line element. `dash`: SVG dash pattern, empty for a solid line.
std::string svg_line(double x1, double y1, double x2, double y2, std::string_view colour, double width,
                     std::string_view dash = {});
/// Filled rectangle. `radius` of the corners [px].
std::string svg_box(const Rectangle& box, std::string_view colour, double radius = 0.0, double opacity = 1.0);

/// Estimated width of text in the system font [px]. The viewer's font is unknown when the figure is written.
double text_width(std::string_view text, double size = 11.0);

/// Width of the labels left of a vertical axis [px].
double label_room(const Ticks& ticks);

/// Grid lines, labels and title (above the top left corner) of a vertical axis.
std::string draw_vertical_axis(const Axis& axis, const PlannedAxis& plan, const Rectangle& area);

/// Axis line and tick marks of a horizontal axis; labels and title below only if `with_labels`.
std::string draw_horizontal_axis(const Axis& axis, const PlannedAxis& plan, const Rectangle& area, bool with_labels);
struct FrameLayout {
    /// Height of tick labels and title below a horizontal axis [px].
    double horizontal_axis_height = 40.0;
};
inline constexpr FrameLayout frame_layout;

/// Vertical lines at values of a horizontal scale over the height of the area, labels at the top. Lines outside the
/// area are omitted.
std::string draw_vertical_references(const std::vector<ReferenceLine>& lines, const Scale& scale,
                                     const Rectangle& area);

/// Entry of a legend.
struct LegendEntry {
    std::string name;
    std::string sign;  // SVG of the symbol around (0, 0), 22 px wide
};

/// Legend entries from (left, top), wrapped at `width`. `height` returns the height used [px].
std::string draw_legend(const std::vector<LegendEntry>& entries, double left, double top, double width, double& height);

/// Colour of a slot as text; slots beyond the palette repeat, negative ones are ink.
std::string_view slot_colour(int slot);

/// Title line; `height` returns its height [px], 0 for an empty title.
std::string draw_title(const std::string& title, double left, double& height);

}  // namespace myo::report
