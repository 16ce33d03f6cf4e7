#include "base/markup.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>

namespace myo {
namespace {

struct MarkupLayout {
    double outside = 1e5;
};
constexpr MarkupLayout markup_layout;

constexpr std::string_view replacement = "\xEF\xBF\xBD";  // U+FFFD
constexpr std::string_view minus = "\xE2\x88\x92";        // U+2212

// Length of the UTF-8 sequence at the start; 0 if it is invalid, overlong or a surrogate.
std::size_t sequence_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    const std::size_t length = first < 0x80   ? 1
                               : first < 0xC2 ? 0
                               : first < 0xE0 ? 2
                               : first < 0xF0 ? 3
                               : first < 0xF5 ? 4
                                              : 0;
    if (length == 0 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xC0) != 0x80) return 0;
    if (first == 0xE0 && byte(1) < 0xA0) return 0;
    if (first == 0xED && byte(1) > 0x9F) return 0;
    if (first == 0xF0 && byte(1) < 0x90) return 0;
    if (first == 0xF4 && byte(1) > 0x8F) return 0;
    // U+FFFE and U+FFFF are not allowed in XML.
    if (first == 0xEF && byte(1) == 0xBF && byte(2) >= 0xBE) return 0;
    return length;
}

/// Entity of a character; empty if it needs none.
std::string_view entity(char c) {
    switch (c) {
        case '&': return "&amp;";
        case '<': return "&lt;";
        case '>': return "&gt;";
        case '"': return "&quot;";
        case '\'': return "&#39;";
        default: return {};
    }
}

/// Fixed decimals, independent of the locale, "-0.00" as "0.00".
std::string fixed_ascii(double value, int decimals) {
    std::array<char, 400> buffer;
    const auto [end, code] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                           std::chars_format::fixed, decimals);
    assert(code == std::errc{});
    std::string text(buffer.data(), end);
    if (text.front() == '-' && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
    return text;
}

std::string with_true_minus(const std::string& text) {
    return !text.empty() && text.front() == '-' ? std::string(minus) + text.substr(1) : text;
}

}  // namespace

std::string escape_markup(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    // Control characters other than tab and line ends are not allowed in XML.
    while (!text.empty()) {
        const std::size_t length = sequence_length(text);
        const bool control = length == 1 && static_cast<unsigned char>(text[0]) < 0x20 && text[0] != '\t' &&
                             text[0] != '\n' && text[0] != '\r';
        if (length == 0 || control) {
            out += replacement;
        } else if (const std::string_view escaped = entity(text[0]); !escaped.empty()) {
            out += escaped;
        } else {
            out += text.substr(0, length);
        }
        // An invalid byte is replaced by itself; decoding continues with the next byte.
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return out;
}

int character_count(std::string_view text) {
    return static_cast<int>(
        // Continuation bytes of UTF-8 have the form 10xxxxxx.
        std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string svg_number(double value) {
    // NaN would make the whole path invalid SVG.
    if (std::isnan(value)) value = -markup_layout.outside;
    std::string text = fixed_ascii(std::clamp(value, -markup_layout.outside, markup_layout.outside), 2);
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
    return text;
}

std::string fixed_decimals(double value, int decimals) {
    assert(std::isfinite(value));
    return with_true_minus(fixed_ascii(value, decimals));
}

std::string power_of_ten(int exponent) {
    constexpr std::array<std::string_view, 10> digits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = "10";
    if (exponent < 0) text += "⁻";
    for (const char c : std::to_string(std::abs(exponent))) text += digits[static_cast<std::size_t>(c - '0')];
    return text;
}

std::string readable_number(double value, int digits) {
    assert(digits >= 1);
    if (!std::isfinite(value)) return "–";
    if (value == 0.0) return "0";
    std::array<char, 64> buffer;
    // Scientific format first: its exponent is the one after rounding to `digits`.
    const auto [end, code] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                           std::chars_format::scientific, digits - 1);
    assert(code == std::errc{});
    const std::string text(buffer.data(), end);  // e.g. "-2.600e+05"
    const std::size_t e = text.find('e');
    const int exponent = std::stoi(text.substr(e + 1));
    if (exponent >= -4 && exponent < 7) return fixed_decimals(value, std::max(0, digits - 1 - exponent));
    return with_true_minus(text.substr(0, e)) + " × " + power_of_ten(exponent);
}

}  // namespace myo
