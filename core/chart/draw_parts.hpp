#pragma once

#include "chart/drawing.hpp"

namespace myo::chart {

/// Parts of a drawing; each appends marks.

/// Straight line.
Stroke straight(double x1, double y1, double x2, double y2, const Colour& colour, double width);

/// Grid lines, labels and title (above the area) of a vertical axis.
void draw_vertical_axis(const Axis& axis, const PlacedPanel& panel, const Layout& layout, const Palette& palette,
                        Drawing& drawing);

/// Axis line, tick marks and grid lines of the horizontal axis; labels and title below only if `labels`.
void draw_horizontal_axis(const Axis& axis, const Rectangle& area, bool labels, const Layout& layout,
                          const Palette& palette, Drawing& drawing);

/// Horizontal and vertical reference lines and notes, with their labels. Those outside the area are left out.
void draw_references(const Panel& panel, const PlacedPanel& placed, const Layout& layout, const Palette& palette,
                     Drawing& drawing);

/// Shading of the spans, which is drawn below the grid.
void draw_span_shades(const Panel& panel, const PlacedPanel& placed, const Layout& layout, const Palette& palette,
                      Drawing& drawing);
/// Labels of the spans at the lower edge of the area.
void draw_span_labels(const Panel& panel, const PlacedPanel& placed, const Layout& layout, const Palette& palette,
                      Drawing& drawing);

/// Band, curve, dots or bars of a series. The caller clips to the area.
void draw_series(const Series& series, const LegendEntry& look, const PlacedPanel& placed, const Layout& layout,
                 const Palette& palette, Drawing& drawing);

}  // namespace myo::chart
