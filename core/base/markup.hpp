#pragma once

#include <string>
#include <string_view>

namespace myo {

/// Text escaped for XML or HTML content and attribute values: & < > " ' become entities; invalid UTF-8 and characters
/// that XML forbids become U+FFFD.
std::string escape_markup(std::string_view text);

/// Number of code points of UTF-8 text, for estimating widths.
int character_count(std::string_view text);

/// Number of an SVG attribute (a coordinate in pixels) with at most two decimals, never "-0", "nan" or "inf". Values
/// that cannot be drawn are moved far outside (10^5 px), where they are clipped. Independent of the locale.
std::string svg_number(double value);

/// Number with a fixed number of decimals and the minus sign U+2212; never "-0". `value` must be finite (asserted).
std::string fixed_decimals(double value, int decimals);

/// Power of ten with superscript digits, e.g. "10⁻³".
std::string power_of_ten(int exponent);

/// Readable number for tables with `digits` significant digits, in the form "2.600 × 10⁵" from 10⁷ on or below 10⁻⁴;
/// "–" if not finite.
std::string readable_number(double value, int digits);

}  // namespace myo
