#include "plot/ticks.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <limits>

namespace myo::ui::plot {
namespace {

/// Replaces the hyphen of a negative number by a minus sign, and removes it from a number whose digits are all zero.
std::string with_true_minus(std::string text) {
    if (text.empty() || text[0] != '-') return text;
    if (text.find_first_of("123456789") == std::string::npos) return text.substr(1);
    return "\xe2\x88\x92" + text.substr(1);
}

std::string printed(const char* format, int digits, double value) {
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, format, digits, value);
    return with_true_minus(buffer);
}

}  // namespace

double nice_step(double step) {
    assert(step > 0.0 && std::isfinite(step));
    const double power = std::pow(10.0, std::floor(std::log10(step)));
    for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
        // A rounding error must not increase 0.2 to 0.5.
        if (factor * power >= step * (1.0 - 1e-9)) return factor * power;
    }
    return 10.0 * power;
}

Ticks make_ticks(const Range& range, int most) {
    Ticks ticks;
    if (!std::isfinite(range.lowest) || !std::isfinite(range.highest) || !(range.span() > 0.0) || most < 1)
        return ticks;
    // Below the resolution of double precision all labels would be equal.
    const double largest = std::max(std::abs(range.lowest), std::abs(range.highest));
    if (range.span() < 1e-12 * largest) return ticks;
    ticks.step = nice_step(range.span() / most);
    const auto first = [&] { return std::ceil(range.lowest / ticks.step - 1e-9); };
    const auto last = [&] { return std::floor(range.highest / ticks.step + 1e-9); };
    // `step` is at least span / most, so at worst one tick is too many.
    if (last() - first() + 1.0 > most) ticks.step = nice_step(1.5 * ticks.step);
    for (double k = first(); k <= last(); k += 1.0) ticks.values.push_back(k * ticks.step);
    return ticks;
}

std::string tick_label(double value, double step) {
    // Sums of decimal steps leave 1e-17 in place of zero.
    if (std::abs(value) < 1e-9 * step) value = 0.0;
    const double largest = std::max(std::abs(value), step);
    // Outside this range fixed decimals would be long or all zero: use at most six significant digits instead.
    if (largest >= 1e6 || step < 1e-6) return printed("%.*g", 6, value);
    const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
    return printed("%.*f", decimals, value);
}

std::string plain_label(double value, int significant_digits) {
    return std::isfinite(value) ? printed("%.*g", significant_digits, value) : "\xe2\x80\x93";
}

std::string label_with_deviation(double value, double deviation) {
    if (!std::isfinite(deviation) || !(deviation > 0.0) || !std::isfinite(value)) return value_label(value, 4);
    // Two digits of the deviation determine how many digits of the value are significant.
    const int decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(deviation))), 0, 12);
    return printed("%.*f", decimals, value) + " \xc2\xb1 " + printed("%.*f", decimals, deviation);
}

std::string value_label(double value, int significant_digits) {
    if (!std::isfinite(value)) return "\xe2\x80\x93";
    const double magnitude = std::abs(value);
    if (magnitude != 0.0 && (magnitude >= 1e7 || magnitude < 1e-5)) return printed("%.*g", significant_digits, value);
    // Digits before the decimal point, to find how many remain for the decimals.
    const int before = magnitude > 0.0 ? static_cast<int>(std::floor(std::log10(magnitude))) + 1 : 1;
    return printed("%.*f", std::max(0, significant_digits - before), value);
}

std::string millimetres(double metres) { return value_label(1e3 * metres, 3) + " mm"; }

Range range_of(const std::vector<const double*>& starts, const std::vector<long>& counts) {
    assert(starts.size() == counts.size());
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -lowest;
    for (std::size_t s = 0; s < starts.size(); ++s) {
        for (long i = 0; i < counts[s]; ++i) {
            const double v = starts[s][i];
            if (!std::isfinite(v)) continue;
            lowest = std::min(lowest, v);
            highest = std::max(highest, v);
        }
    }
    if (lowest > highest) return {};
    return {lowest, highest};
}

Range padded(const Range& range, double part) {
    const double span = range.span();
    // A constant curve has no span. It gets a range of a thousandth of its value, at least 1e-3, to be drawn in the
    // middle.
    if (span > 0.0) return {range.lowest - part * span, range.highest + part * span};
    const double half = std::max(1e-3 * std::abs(range.lowest), 1e-3);
    return {range.lowest - half, range.highest + half};
}

Range zoomed(const Range& range, double fixed, double factor) {
    return {fixed + factor * (range.lowest - fixed), fixed + factor * (range.highest - fixed)};
}

double to_pixel(const Range& range, double value, double from, double to) {
    return from + (value - range.lowest) / range.span() * (to - from);
}

double from_pixel(const Range& range, double pixel, double from, double to) {
    return range.lowest + (pixel - from) / (to - from) * range.span();
}

}  // namespace myo::ui::plot
