#pragma once

#include <cmath>

namespace myo::planning {

/// Two significant digits, as a person sets them: by `to`, a rounding function.
/// The result is again a double; printed with few digits it is the decimal number.
template <class Rounding>
double rounded_by(double value, const Rounding& to) {
    if (!(std::abs(value) > 0.0)) return 0.0;
    const double last_digit = std::floor(std::log10(std::abs(value))) - 1.0;
    // Division by a whole power of ten gives the double next to the decimal number. A thousandth of a digit is
    // rounding.
    return last_digit < 0.0 ? to(value * std::pow(10.0, -last_digit) + 1e-3) / std::pow(10.0, -last_digit)
                            : to(value / std::pow(10.0, last_digit) + 1e-3) * std::pow(10.0, last_digit);
}

/// To the nearest number of two digits.
inline double rounded(double value) {
    return rounded_by(value, [](double x) { return std::round(x); });
}
/// To the next smaller one, for limits; value >= 0.
inline double rounded_down(double value) {
    return rounded_by(value, [](double x) { return std::floor(x); });
}
/// To the next smaller multiple of a power of ten that is at most `digit` (> 0).
inline double rounded_down_to(double value, double digit) {
    const double per_unit = std::pow(10.0, -std::floor(std::log10(digit)));
    // A millionth of a digit is rounding.
    return std::floor(value * per_unit + 1e-6) / per_unit;
}

}  // namespace myo::planning
