#include "chart/colour.hpp"

#include "chart/palette.hpp"

namespace myo::chart {

std::string hex_of(const Colour& colour) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text = "#";
    for (int shift = 20; shift >= 0; shift -= 4) text += digits[(colour.rgb >> shift) & 15u];
    return text;
}

const Palette& print_palette() {
    // Paper and plot have one colour, so that figures have no inner frame.
    static const Palette palette = [] {
        const Colour paper = colour_of(ink::paper), text = colour_of(ink::text);
        Palette made{paper,
                     paper,
                     text,
                     colour_of(ink::quiet),
                     colour_of(ink::axis),
                     colour_of(ink::grid),
                     colour_of(ink::shade),
                     text,
                     {}};
        for (const std::string_view slot : series_palette) made.series.push_back(colour_of(slot));
        return made;
    }();
    return palette;
}

}  // namespace myo::chart
