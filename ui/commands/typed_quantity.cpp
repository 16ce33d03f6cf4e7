#include "commands/typed_quantity.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>

namespace myo::ui::commands {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Text with plain blanks and minus signs, without blanks at its ends.
std::string plain_text(std::string_view text) {
    // The minus sign, no-break, narrow and thin blanks, and tabs: what is pasted from papers and spreadsheets.
    constexpr std::array<std::array<std::string_view, 2>, 5> spellings{
        {{"\xe2\x88\x92", "-"}, {"\xc2\xa0", " "}, {"\xe2\x80\xaf", " "}, {"\xe2\x80\x89", " "}, {"\t", " "}}};
    std::string plain(text);
    for (const auto& [written, replacement] : spellings)
        for (std::size_t at = plain.find(written); at != std::string::npos; at = plain.find(written, at))
            plain.replace(at, written.size(), replacement);
    plain.erase(0, plain.find_first_not_of(' '));
    plain.erase(plain.find_last_not_of(' ') + 1);
    return plain;
}

/// A decimal number as it is written: (whole.decimals) * 10^exponent.
struct WrittenNumber {
    bool negative = false;
    std::string whole, decimals;  // digits; one of them may be empty
    int exponent = 0;
    int marks = 0;           // points and commas
    char mark = '\0';        // the last of them
    bool grouped = false;    // blanks separate thousands
    std::size_t length = 0;  // characters of the text that belong to the number
    bool is_number() const { return !whole.empty() || !decimals.empty(); }
};

/// Whether a blank at this place separates thousands: between one to three digits and exactly three.
bool separates_thousands(const std::string& text, std::size_t at, std::size_t group) {
    std::size_t end = at + 1;
    while (end < text.size() && is_digit(text[end])) ++end;
    return group >= 1 && group <= 3 && end - at == 4;
}

/// Reads digits, marks and blanks between thousands from `at` on.
void read_digits(const std::string& text, std::size_t& at, WrittenNumber& number) {
    std::size_t group = 0;  // digits since the last separator
    for (; at < text.size(); ++at) {
        const char c = text[at];
        if (is_digit(c)) {
            (number.marks > 0 ? number.decimals : number.whole) += c;
            ++group;
        } else if (c == '.' || c == ',') {
            ++number.marks;
            number.mark = c;
        } else if (c == ' ' && number.marks == 0 && separates_thousands(text, at, group)) {
            number.grouped = true;
            group = 0;
        } else {
            return;
        }
    }
}

/// Reads "e-3" at `at`, if it is there. Exponents beyond those of doubles are cut off at a size that is out of range,
/// too.
void read_exponent(const std::string& text, std::size_t& at, WrittenNumber& number) {
    if (at >= text.size() || (text[at] != 'e' && text[at] != 'E')) return;
    std::size_t digit = at + 1;
    const bool negative = digit < text.size() && text[digit] == '-';
    if (digit < text.size() && (text[digit] == '-' || text[digit] == '+')) ++digit;
    if (digit >= text.size() || !is_digit(text[digit])) return;
    constexpr int out_of_range = 100000;
    for (; digit < text.size() && is_digit(text[digit]); ++digit)
        number.exponent = std::min(10 * number.exponent + (text[digit] - '0'), out_of_range);
    if (negative) number.exponent = -number.exponent;
    at = digit;
}

/// The number at the beginning of a text; without digits if there is none.
WrittenNumber read_number(const std::string& text) {
    WrittenNumber number;
    std::size_t at = 0;
    if (!text.empty() && (text[0] == '-' || text[0] == '+')) number.negative = text[at++] == '-';
    read_digits(text, at, number);
    if (number.is_number()) read_exponent(text, at, number);
    number.length = at;
    return number;
}

/// Whether a single comma may separate thousands as well as decimals: "1,250", not "0,125" or "1,25".
bool reads_in_two_ways(const WrittenNumber& number) {
    return number.mark == ',' && !number.grouped && number.decimals.size() == 3 && !number.whole.empty() &&
           number.whole.size() <= 3 && number.whole[0] != '0';
}

/// Whether the rest of a text looks like a unit, known or not: one word of letters with a slash or a power.
bool looks_like_unit(std::string_view rest) {
    const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c & 0x80) != 0; };
    return (letter(rest[0]) || rest[0] == '%' || rest[0] == '/') && std::all_of(rest.begin(), rest.end(), [&](char c) {
               return letter(c) || is_digit(c) || c == '%' || c == '/' || c == '^';
           });
}

/// What a dimension is called in messages.
std::string dimension_name(Dimension dimension) {
    switch (dimension) {
        case Dimension::number: return "plain numbers";
        case Dimension::ratio: return "ratios";
        case Dimension::length: return "length";
        case Dimension::angle: return "angle";
        case Dimension::time: return "time";
        case Dimension::frequency: return "frequency";
        case Dimension::mass: return "mass";
        case Dimension::density: return "density";
        case Dimension::force: return "force";
        case Dimension::torque: return "torque";
        case Dimension::pressure: return "pressure";
        case Dimension::acceleration: return "acceleration";
        case Dimension::velocity: return "velocity";
        case Dimension::volume: return "volume";
        case Dimension::stiffness: return "stiffness";
    }
    return "";
}

/// Why a word is no unit of the dimension, with the units to use.
Error unit_error(const std::string& unit, Dimension dimension) {
    const std::string refused = "'" + unit + "' is not a unit of " + dimension_name(dimension);
    if (dimension == Dimension::number) return {"'" + unit + "' is not expected: this number has no unit", ""};
    if (dimension == Dimension::ratio) return {refused + ": use % or no unit", ""};
    if (const Unit* meant = find_unit_in_any_case(dimension, unit))
        return {refused + ": write " + meant->name + ", where capitals matter", ""};
    return {refused + ": use " + offered_units(dimension), ""};
}

/// SI value of a number in a unit; empty if no double has it.
std::optional<double> si_value(const WrittenNumber& number, const Unit& unit) {
    // The power of ten of the unit goes into the text, so that the conversion rounds once.
    const std::string text = (number.negative ? "-" : "") + (number.whole.empty() ? "0" : number.whole) + "." +
                             (number.decimals.empty() ? "0" : number.decimals) + "e" +
                             std::to_string(number.exponent + unit.exponent);
    double value = 0.0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code != std::errc{} || !std::isfinite(value * unit.factor)) return std::nullopt;
    return value * unit.factor;
}

/// The number at the beginning of a text.
///
/// Errors: there is none; several decimal marks; a comma that may separate thousands as well as decimals.
Result<WrittenNumber> read_unambiguous(const std::string& text) {
    const WrittenNumber number = read_number(text);
    if (!number.is_number()) return Error{"'" + text + "' is not a number", ""};
    const std::string written = text.substr(0, number.length);
    if (number.marks > 1)
        return Error{"'" + written + "' has several separators: write thousands without one, such as 1000.5", ""};
    // Neither reading is guessed: one of them would be wrong by a factor of a thousand.
    if (reads_in_two_ways(number))
        return Error{"'" + written + "' can be read in two ways: write " + number.whole + "." + number.decimals +
                         " or " + number.whole + number.decimals,
                     ""};
    return number;
}

/// Digits of a double and its decimal exponent: value = 0.digits * 10^exponent.
struct ShortestDecimal {
    std::string digits;
    int exponent;
};

/// The shortest one that reads as the same double.
ShortestDecimal shortest_decimal(double magnitude) {
    std::array<char, 40> buffer;
    const auto [end, code] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), magnitude,
                                           std::chars_format::scientific);
    assert(code == std::errc{});
    const std::string text(buffer.data(), end);
    const std::size_t e = text.find('e');
    std::string digits = text.substr(0, e);
    std::erase(digits, '.');
    return {digits, std::stoi(text.substr(e + 1)) + 1};
}

/// Writes a decimal as "0.0012", "1200" or, far from 1, as "1.2e-7".
std::string written(const ShortestDecimal& decimal) {
    const int count = static_cast<int>(decimal.digits.size()), exponent = decimal.exponent;
    if (exponent < -4 || exponent > 15) {
        const std::string rest = decimal.digits.substr(1);
        return decimal.digits.substr(0, 1) + (rest.empty() ? "" : "." + rest) + "e" + std::to_string(exponent - 1);
    }
    if (exponent <= 0) return "0." + std::string(static_cast<std::size_t>(-exponent), '0') + decimal.digits;
    if (exponent >= count) return decimal.digits + std::string(static_cast<std::size_t>(exponent - count), '0');
    const auto point = static_cast<std::size_t>(exponent);
    return decimal.digits.substr(0, point) + "." + decimal.digits.substr(point);
}

/// A number with its unit, if that has a name.
std::string with_unit(const std::string& number, const Unit& unit) {
    return unit.name[0] == '\0' ? number : number + " " + unit.name;
}

/// Shortest text of value / 10^shift. The shift moves the decimal point only, so that no digit is rounded.
std::string signed_text(double value, int shift) {
    if (value == 0.0) return "0";
    ShortestDecimal decimal = shortest_decimal(std::abs(value));
    decimal.exponent -= shift;
    return (value < 0.0 ? "-" : "") + written(decimal);
}

/// A limit for a message. One with many digits is rounded to four, into the range, so that it can be typed.
std::string limit_text(double limit, bool highest, const QuantityRange& range) {
    const std::string exact = edited_text(limit, range.dimension, range.unit);
    if (limit == 0.0 || shortest_decimal(std::abs(limit)).digits.size() <= 6) return exact;
    const double digit = std::pow(10.0, std::floor(std::log10(std::abs(limit))) - 3.0);
    const double rounded = digit * (highest ? std::floor(limit / digit) : std::ceil(limit / digit));
    return displayed_text(rounded, range.dimension, range.unit);
}

}  // namespace

Result<double> parse_quantity(std::string_view text, Dimension dimension, std::string_view shown_unit) {
    const Unit* unit = find_unit(dimension, shown_unit);
    assert(unit != nullptr);
    const std::string plain = plain_text(text);
    if (plain.empty()) return Error{"Nothing is typed: a number is needed", ""};
    const Result<WrittenNumber> number = read_unambiguous(plain);
    if (!number) return number.error();
    const std::string rest = plain_text(plain.substr(number->length));
    if (!rest.empty()) {
        unit = find_unit(dimension, rest);
        if (unit == nullptr && !looks_like_unit(rest)) return Error{"'" + plain + "' is not a number", ""};
        if (unit == nullptr) return unit_error(rest, dimension);
    }
    const std::optional<double> value = si_value(*number, *unit);
    if (!value) return Error{"'" + plain + "' is too large or too small a number", ""};
    return *value;
}

Result<double> accept_quantity(std::string_view text, const QuantityRange& range) {
    const Result<double> value = parse_quantity(text, range.dimension, range.unit);
    if (!value) return value;
    const std::string typed = plain_text(text);
    if (range.whole_number && *value != std::round(*value)) return Error{typed + " is not a whole number", ""};
    if (*value > range.limits.highest)
        return Error{
            typed + " is above the highest " + range.quantity + ", " + limit_text(range.limits.highest, true, range),
            ""};
    if (*value < range.limits.lowest)
        return Error{
            typed + " is below the lowest " + range.quantity + ", " + limit_text(range.limits.lowest, false, range),
            ""};
    return value;
}

std::string edited_text(double value, Dimension dimension, std::string_view unit) {
    assert(std::isfinite(value));
    const Unit* shown = find_unit(dimension, unit);
    assert(shown != nullptr);
    if (shown->factor == 1.0) return with_unit(signed_text(value, shown->exponent), *shown);
    const std::string text = with_unit(signed_text(value / shown->factor, shown->exponent), *shown);
    // A factor that is no power of ten rounds: the text counts only if it leads back to the value.
    const Result<double> read = parse_quantity(text, dimension, unit);
    if (read && *read == value) return text;
    return with_unit(signed_text(value, 0), si_unit(dimension));
}

std::string displayed_text(double value, Dimension dimension, std::string_view unit) {
    const Unit* shown = find_unit(dimension, unit);
    assert(shown != nullptr);
    std::array<char, 40> buffer;
    // A negative zero is zero.
    std::snprintf(buffer.data(), buffer.size(), "%.5g", value / shown->si() + 0.0);
    return with_unit(buffer.data(), *shown);
}

}  // namespace myo::ui::commands
