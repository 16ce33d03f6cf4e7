#include "law/unit.hpp"

#include <cctype>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text.hpp"

namespace myo::law {
namespace {

struct NamedUnit {
    std::string_view word;
    Unit unit;
};
// Angles are plain numbers.
constexpr NamedUnit named_units[] = {
    {"1", {}},
    {"rad", {}},
    {"deg", {}},
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

/// Endings of names in which the catalogue of effects leaves the stroke of the fraction out.
constexpr std::pair<std::string_view, std::string_view> catalogue_endings[] = {
    {"_kg_m3", "kg/m3"}, {"_kg_m2", "kg/m2"}, {"_Pa_s_m", "Pa s/m"}, {"_J_m3", "J/m3"},
    {"_N_m", "N/m"},     {"_m_s", "m/s"},     {"_m_s2", "m/s2"},     {"_1_m", "1/m"},
    {"_1_s", "1/s"},     {"_rad_s", "rad/s"}, {"_N_s_m", "N s/m"},   {"_kg_m", "kg/m"},
};

/// One unit with its exponent: "m3", "s^2".
std::optional<Unit> unit_word(std::string_view word) {
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

std::vector<std::string> parts_of(const std::string& text, char separator) {
    std::vector<std::string> parts{""};
    for (const char c : text)
        if (c == separator)
            parts.emplace_back();
        else
            parts.back() += c;
    return parts;
}

/// Words of a unit from the last parts of a name on, "per" as the stroke; empty if one of them is no unit.
std::string joined(const std::vector<std::string>& parts, std::size_t from) {
    std::string words;
    bool after_stroke = false;
    for (std::size_t i = from; i < parts.size(); ++i) {
        if (parts[i] == "per") {
            if (words.empty()) words = "1";
            after_stroke = true;
            continue;
        }
        // "_1_m2" is 1/m2.
        after_stroke = after_stroke || (parts[i] == "1" && i == from && i + 1 < parts.size());
        if (!unit_word(parts[i])) return {};
        words += (words.empty() ? "" : after_stroke ? "/" : " ") + parts[i];
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
    for (const auto& [ending, words] : catalogue_endings)
        if (name.size() > ending.size() && std::string_view(name).ends_with(ending)) return std::string(words);
    const std::vector<std::string> parts = parts_of(name, '_');
    std::string best;
    // The first part is never the unit.
    for (std::size_t from = parts.size(); from-- > 1;) {
        const std::string words = joined(parts, from);
        if (words.empty()) break;
        best = words;
    }
    return best;
}

std::string to_string(const Unit& unit) {
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
