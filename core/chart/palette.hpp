#pragma once

#include <array>
#include <string_view>

namespace myo::chart {

/// Series colours on white. Each has a contrast of at least 3 : 1, and every pair has a CIE76 difference above 30, also
/// for readers without red, green or blue cones. Found by random search under these conditions, which a test verifies.
inline constexpr std::array<std::string_view, 6> series_palette = {"#0072b2", "#d55e00", "#873ff1",
                                                                   "#493b10", "#c3807b", "#72144e"};

/// Colours of background and text. Figures keep a white background in a dark report, so that they print the same.
namespace ink {
// Background.
inline constexpr std::string_view paper = "#ffffff";
// Titles and names.
inline constexpr std::string_view text = "#1b1f24";
// Secondary text, e.g. tick labels.
inline constexpr std::string_view quiet = "#57606a";
// Axis lines and ticks.
inline constexpr std::string_view axis = "#8c959f";
inline constexpr std::string_view grid = "#e6e8eb";
// Background of spans.
inline constexpr std::string_view shade = "#f1f3f5";
}  // namespace ink

}  // namespace myo::chart
