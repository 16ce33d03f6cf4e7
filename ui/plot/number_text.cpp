#include "plot/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace myo::ui::plot {
namespace {

/// Replaces the hyphen of a negative number by a minus sign, and removes it from a number whose digits are all zero.
std::string with_true_minus(std::string text) {
    if (text.empty() || text[0] != '-') return text;
    if (text.find_first_of("123456789") == std::string::npos) return text.substr(1);
    return "\xe2\x88\x92" + text.substr(1);
}

/// A number by a format of printf with a number of digits.
std::string printed(const char* format, int digits, double value) {
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, format, digits, value);
    return with_true_minus(buffer);
}

}  // namespace

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

}  // namespace myo::ui::plot
