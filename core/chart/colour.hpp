#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace myo::chart {

/// A colour: sRGB as 0xRRGGBB, and its opacity from 0 to 1.
struct Colour {
    std::uint32_t rgb = 0;
    double opacity = 1.0;
    bool operator==(const Colour&) const = default;
};

/// Colour of a text "#rrggbb" in lower case; other texts give another colour, not an error.
constexpr Colour colour_of(std::string_view hex) {
    Colour colour;
    for (const char c : hex.substr(1))
        colour.rgb = 16 * colour.rgb + static_cast<std::uint32_t>(c <= '9' ? c - '0' : c - 'a' + 10);
    return colour;
}

/// The text "#rrggbb" of a colour, without its opacity.
std::string hex_of(const Colour& colour);

/// Returns the colour with its opacity multiplied by `factor`.
constexpr Colour faded(const Colour& colour, double factor) { return {colour.rgb, factor * colour.opacity}; }

/// Colours of a chart by role. Pages use print_palette(); the window converts its theme.
struct Palette {
    Colour paper;                // behind the whole chart
    Colour plot;                 // behind the curves
    Colour text;                 // titles and names
    Colour quiet;                // secondary text, e.g. tick labels
    Colour axis;                 // axis lines and ticks
    Colour grid;                 // grid lines
    Colour shade;                // background of spans
    Colour legend;               // names in the legend
    std::vector<Colour> series;  // slots of Series::colour; not empty

    /// Colour of a slot; slots beyond the palette repeat, negative ones are the text colour.
    const Colour& slot(int index) const {
        return index < 0 ? text : series[static_cast<std::size_t>(index) % series.size()];
    }
};

/// Colours on white paper. Figures of pages keep them in a dark report, so that they print the same.
const Palette& print_palette();

}  // namespace myo::chart
