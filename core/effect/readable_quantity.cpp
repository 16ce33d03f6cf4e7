#include "effect/readable_quantity.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "law/unit.hpp"

namespace myo::effect {
namespace {

/// Unit suffix of a name and how it is displayed.
struct UnitSuffix {
    const char* suffix;
    const char* unit;
    double factor;
};
/// Longer suffixes precede those that they end with.
constexpr UnitSuffix unit_suffixes[] = {
    {"_kg_m3", "kg/m³", 1.0},
    {"_kg_m2", "kg/m²", 1.0},
    {"_Pa_s_m", "Pa s/m", 1.0},
    {"_Pa_per_m", "MPa/m", 1e-6},
    {"_J_m3", "J/m³", 1.0},
    {"_N_m", "N/m", 1.0},
    {"_N", "mN", 1e3},
    {"_1_m", "1/m", 1.0},
    {"_1_s", "1/s", 1.0},
    {"_kg", "g", 1e3},
    {"_deg", "°", 1.0},
    {"_Pa", "kPa", 1e-3},
    {"_Hz", "Hz", 1.0},
    {"_rad", "rad", 1.0},
    {"_m", "mm", 1e3},
    {"_s", "ms", 1e3},
    {"relative_change", "%", 100.0},
    {"relative_error", "%", 100.0},
};

// Underscores become spaces.
std::string spaced(std::string words) {
    std::replace(words.begin(), words.end(), '_', ' ');
    return words;
}

}  // namespace

std::string effect_name(const std::string& id) {
    std::string name = spaced(id);
    if (!name.empty()) name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
    return name;
}

ReadableQuantity readable_quantity(const std::string& name) {
    const std::string words = law::unit_of_name(name);
    for (const UnitSuffix& known : unit_suffixes) {
        if (!name.ends_with(known.suffix)) continue;
        const bool is_unit = known.suffix[0] == '_';
        // The ending of a longer unit is none: stiffness_N_per_m is not in m.
        if (is_unit && law::unit_of_name("x" + std::string(known.suffix)) != words) break;
        return {spaced(is_unit ? name.substr(0, name.size() - std::string_view(known.suffix).size()) : name),
                known.unit, known.factor};
    }
    if (words.empty()) return {spaced(name), "", 1.0};
    std::size_t from = name.rfind('_');
    while (law::unit_of_name("x" + name.substr(from)) != words) from = name.rfind('_', from - 1);
    return {spaced(name.substr(0, from)), words, 1.0};
}

}  // namespace myo::effect
