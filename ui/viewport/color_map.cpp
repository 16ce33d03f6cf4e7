#include "viewport/color_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace myo::ui::viewport {
namespace {

// Converts CIE LCh (D65 white point) to sRGB. Colours outside sRGB are clipped.
Eigen::Vector3f srgb_from_lch(double L, double C, double hue_deg) {
    const double hue = hue_deg * std::numbers::pi / 180.0;
    const double fy = (L + 16.0) / 116.0;
    const std::array<double, 3> f{fy + C * std::cos(hue) / 500.0, fy, fy - C * std::sin(hue) / 200.0};
    const std::array<double, 3> white{0.95047, 1.0, 1.08883};
    Eigen::Vector3d xyz;
    for (int i = 0; i < 3; ++i) {
        const double t = f[static_cast<std::size_t>(i)];
        xyz[i] = white[static_cast<std::size_t>(i)] *
                 (t > 6.0 / 29.0 ? t * t * t : 3.0 * 36.0 / 841.0 * (t - 4.0 / 29.0));
    }
    Eigen::Matrix3d to_rgb;
    to_rgb << 3.2406, -1.5372, -0.4986, -0.9689, 1.8758, 0.0415, 0.0557, -0.2040, 1.0570;
    const Eigen::Vector3d linear = (to_rgb * xyz).cwiseMax(0.0).cwiseMin(1.0);
    return linear
        .unaryExpr([](double v) { return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055; })
        .cast<float>();
}

/// Control point of a colour map in CIE LCh.
struct Control {
    double L, C, hue;
};  // lightness, chroma, hue [degrees]

/// Interpolates between control points at equal distances. `level` is limited to [0, 1]; a value that is not finite
/// counts as 0.
template <std::size_t n>
Eigen::Vector3f between(const std::array<Control, n>& controls, double level) {
    const double place = std::clamp(std::isfinite(level) ? level : 0.0, 0.0, 1.0) * static_cast<double>(n - 1);
    const auto i = std::min(static_cast<std::size_t>(place), controls.size() - 2);
    const double s = place - static_cast<double>(i);
    const auto mix = [s](double a, double b) { return a + s * (b - a); };
    const Control &a = controls[i], &b = controls[i + 1];
    return srgb_from_lch(mix(a.L, b.L), mix(a.C, b.C), mix(a.hue, b.hue));
}

// Lightness rises linearly through the hues of glowing iron: black, red, yellow, white.
Eigen::Vector3f heat_color_map(double level) {
    return between(std::array<Control, 5>{{{6, 8, -20}, {28, 55, 25}, {50, 78, 44}, {72, 72, 72}, {95, 22, 98}}},
                   level);
}

Eigen::Vector3f grey_color_map(double level) {
    return between(std::array<Control, 2>{{{10, 0, 0}, {95, 0, 0}}}, level);
}

}  // namespace

Eigen::Vector3f color_map(double level) {
    // Lightness rises linearly while the hue turns from violet to yellow.
    return between(std::array<Control, 5>{{{18, 42, 305}, {37, 40, 270}, {55, 34, 200}, {73, 52, 140}, {91, 80, 102}}},
                   level);
}

Eigen::Vector3f diverging_color_map(double level) {
    // Two arms of equal lightness at equal distance from the middle, where they meet without colour.
    if (level < 0.5) return between(std::array<Control, 3>{{{34, 52, 277}, {64, 34, 262}, {92, 0, 250}}}, 2.0 * level);
    return between(std::array<Control, 3>{{{92, 0, 40}, {64, 48, 40}, {34, 62, 32}}}, 2.0 * level - 1.0);
}

const std::vector<ColorMap>& color_maps() {
    static const std::vector<ColorMap> all{
        {"violet_yellow", "Violet to yellow",
         "From dark to light as the value grows, linear in lightness; suitable for colour vision deficiency.",
         color_map},
        {"heat", "Glowing iron",
         "Black, red, yellow, white: linear in lightness as the value grows, over a wider range of lightness.",
         heat_color_map},
        {"grey", "Grey, for print", "Linear from black to white; leaves the hues to the muscles and markers.",
         grey_color_map}};
    return all;
}

int number_of_color_map(const std::string& id) {
    const auto found = std::find_if(color_maps().begin(), color_maps().end(),
                                    [&](const ColorMap& map) { return map.id == id; });
    return found == color_maps().end() ? 0 : static_cast<int>(found - color_maps().begin());
}

}  // namespace myo::ui::viewport
