#pragma once

#include <string>
#include <string_view>

namespace myo::report {

/// Text as XML or HTML content or attribute value: & < > " ' escaped, bytes that are not UTF-8 and characters that XML
/// forbids replaced by U+FFFD.
std::string escape_markup(std::string_view text);

/// Number of characters (code points) of UTF-8 text, for estimating widths.
int character_count(std::string_view text);

/// Pixel coordinate with at most two decimals, never "-0", "nan" or "inf": what cannot be drawn is pushed to the far
/// outside (10^5 px), where the clip hides it. Locale-free.
std::string pixel(double value);

/// Fixed number of decimals with a true minus sign; never "-0". `value` must be finite.
std::string fixed_decimals(double value, int decimals);

/// "10⁻³"
std::string power_of_ten(int exponent);

/// Readable number for tables: `digits` significant digits, "2.600 × 10⁵"-style beyond 10⁷ or below 10⁻⁴; "–" when not
/// finite.
std::string readable_number(double value, int digits);

}  // namespace myo::report
