#include "law/unit.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text.hpp"

namespace myo::law {
namespace {

/// A word of the SI with its exponents of m, kg, s, K and A.
struct NamedUnit {
    std::string_view word;
    Unit unit;
};
// Angles are plain numbers, in rad.
constexpr NamedUnit named_units[] = {
    {"1", {}},
    {"rad", {}},
    {"m", {{1, 0, 0, 0, 0}}},
    {"kg", {{0, 1, 0, 0, 0}}},
    {"s", {{0, 0, 1, 0, 0}}},
    {"K", {{0, 0, 0, 1, 0}}},
    {"A", {{0, 0, 0, 0, 1}}},
    {"Hz", {{0, 0, -1, 0, 0}}},
    {"N", {{1, 1, -2, 0, 0}}},
    {"Pa", {{-1, 1, -2, 0, 0}}},
    {"J", {{2, 1, -2, 0, 0}}},
    {"W", {{2, 1, -3, 0, 0}}},
    {"V", {{2, 1, -3, 0, -1}}},
};
constexpr std::string_view base_words[] = {"m", "kg", "s", "K", "A"};

/// Units with prefixes, with which names may not end: a value in them would be taken for one in the SI unit.
constexpr std::string_view prefixed_units[] = {"nm",   "um", "mm", "cm",  "km",  "mm2", "cm2", "mm3",
                                               "cm3",  "us", "ms", "hPa", "kPa", "MPa", "GPa", "bar",
                                               "mbar", "mN", "kN", "mJ",  "kJ",  "kHz"};

/// One unit with its exponent: "m3", "s^2".
std::optional<Unit> unit_word(std::string_view word) {
    // The exponent is the digits and signs at the end. The unit "1" is all digits, which end == 0 finds.
    std::size_t end = word.size();
    while (end > 0 && (std::isdigit(static_cast<unsigned char>(word[end - 1])) || word[end - 1] == '-')) --end;
    double exponent = 1.0;
    if (end > 0 && end < word.size() && !parse_number(word.substr(end), exponent)) return std::nullopt;
    std::string_view name = end == 0 ? word : word.substr(0, end);
    if (name.size() > 1 && name.back() == '^') name.remove_suffix(1);
    for (const NamedUnit& known : named_units)
        if (known.word == name) return to_power(known.unit, exponent);
    return std::nullopt;
}

/// Parts of a text between separators; an empty text has one empty part.
std::vector<std::string> parts_of(const std::string& text, char separator) {
    std::vector<std::string> parts{""};
    for (const char c : text)
        if (c == separator)
            parts.emplace_back();
        else
            parts.back() += c;
    return parts;
}

/// Whether the last unit of a name stands below a stroke that is left out, as the catalogue of effects writes: a length
/// does (N_m, Pa_s_m, kg_m3), and a time where it does not follow a force, a pressure or an energy (m_s, but Pa_s).
bool divides(const std::vector<std::string>& parts, std::size_t last) {
    const std::string& before = parts[last - 1];
    return parts[last].front() == 'm' ||
           (parts[last].front() == 's' && before != "N" && before != "Pa" && before != "J");
}

/// Words of a unit from the last parts of a name on, "per" as the stroke; empty if one of them is no unit.
std::string joined(const std::vector<std::string>& parts, std::size_t from) {
    std::string words;
    bool after_stroke = false;
    for (std::size_t i = from; i < parts.size(); ++i) {
        // A name that begins its unit with "per" is a reciprocal: rate_per_s is 1/s.
        if (parts[i] == "per") {
            if (words.empty()) words = "1";
            after_stroke = true;
            continue;
        }
        // The unit "deg" is let through so that a message can name it: laws reject it, angles are in rad.
        if (parts[i] != "deg" && !unit_word(parts[i])) return {};
        // Only the last unit may stand below a stroke that the name leaves out: in Pa_s_m the second of two.
        const bool stroke = after_stroke || (i > from && i + 1 == parts.size() && divides(parts, i));
        words += (words.empty() ? "" : stroke ? "/" : " ") + parts[i];
    }
    return words;
}

}  // namespace

Unit operator*(const Unit& a, const Unit& b) {
    Unit result = a;
    for (std::size_t i = 0; i < result.powers.size(); ++i) result.powers[i] += b.powers[i];
    return result;
}

Unit operator/(const Unit& a, const Unit& b) { return a * to_power(b, -1.0); }

Unit to_power(const Unit& unit, double exponent) {
    Unit result = unit;
    // The sum with 0 turns a zero with a sign into the one without.
    for (double& power : result.powers) power = power * exponent + 0.0;
    return result;
}

std::optional<Unit> unit_from_words(const std::string& words) {
    Unit unit;
    bool below = false;
    std::string word;
    // Multiplies the finished word into the unit. @return  false if the word is no unit
    const auto end_word = [&] {
        if (word.empty()) return true;
        const std::optional<Unit> one = unit_word(word);
        word.clear();
        if (one) unit = below ? unit / *one : unit * *one;
        return one.has_value();
    };
    for (const char c : words) {
        if (c != ' ' && c != '*' && c != '/') {
            word += c;
            continue;
        }
        if (!end_word()) return std::nullopt;
        // What follows a stroke is below it, as in Pa/m s.
        below = below || c == '/';
    }
    if (!end_word()) return std::nullopt;
    return unit;
}

std::string unit_of_name(const std::string& name) {
    const std::vector<std::string> parts = parts_of(name, '_');
    std::string best;
    // The first part is never the unit.
    // The longest ending of which every part is a unit wins: kg_m3, not m3.
    for (std::size_t from = parts.size(); from-- > 1;) {
        const std::string words = joined(parts, from);
        if (words.empty()) break;
        best = words;
    }
    return best;
}

std::string prefixed_ending(const std::string& name) {
    const std::size_t stroke = name.rfind('_');
    const std::string last = stroke == std::string::npos ? "" : name.substr(stroke + 1);
    return std::find(std::begin(prefixed_units), std::end(prefixed_units), last) == std::end(prefixed_units) ? ""
                                                                                                             : last;
}

std::string to_string(const Unit& unit) {
    // Positive exponents stand above the stroke, negative ones below it with their sign left out.
    std::string above, below;
    for (std::size_t i = 0; i < unit.powers.size(); ++i) {
        const double power = unit.powers[i];
        if (power == 0.0) continue;
        std::string& side = power > 0.0 ? above : below;
        side += (side.empty() ? "" : " ") + std::string(base_words[i]);
        if (std::abs(power) != 1.0) side += format_number(std::abs(power));
    }
    if (below.empty()) return above.empty() ? "1" : above;
    return (above.empty() ? "1" : above) + "/" + below;
}

}  // namespace myo::law
