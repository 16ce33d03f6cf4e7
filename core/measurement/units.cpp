#include "measurement/units.hpp"

#include <cctype>
#include <cmath>

#include "base/text.hpp"

namespace myo::measurement {

std::optional<double> metres_per_unit(std::string_view name) {
    // Spellings found in motion-capture files, in lower case; \xC2\xB5 is the micro sign in UTF-8.
    static constexpr std::array<std::pair<std::string_view, double>, 24> units{{
        {"m", 1.0},         {"meter", 1.0},       {"meters", 1.0},       {"metre", 1.0},       {"metres", 1.0},
        {"mm", 1e-3},       {"millimeter", 1e-3}, {"millimeters", 1e-3}, {"millimetre", 1e-3}, {"millimetres", 1e-3},
        {"cm", 1e-2},       {"centimeter", 1e-2}, {"centimeters", 1e-2}, {"centimetre", 1e-2}, {"centimetres", 1e-2},
        {"dm", 1e-1},       {"um", 1e-6},         {"\xC2\xB5m", 1e-6},   {"in", 0.0254},       {"inch", 0.0254},
        {"inches", 0.0254}, {"ft", 0.3048},       {"foot", 0.3048},      {"feet", 0.3048},
    }};
    std::string lower(name);
    for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    for (const auto& [unit, metres] : units) {
        if (lower == unit) return metres;
    }
    return std::nullopt;
}

std::string unit_word(double metres, double within) {
    std::string word;
    double nearest = std::log(within);
    for (const auto& [unit, length] : length_units)
        if (const double off = std::abs(std::log(metres / length)); off <= nearest) word = unit, nearest = off;
    return word;
}

Result<double> recording_unit(const std::string& field, const std::string& stated, std::optional<double> declared,
                              const std::string& where) {
    const std::optional<double> known = metres_per_unit(stated);
    if (!known && !declared)
        return Error{field +
                         (stated.empty() ? " is missing, so the unit of length is not known"
                                         : " is '" + stated + "', which is no known unit of length") +
                         "; state the trial's key unit, for example unit = \"mm\"",
                     where};
    if (known && declared && std::abs(*known / *declared - 1.0) > 1e-9) {
        const std::string word = unit_word(*declared);
        return Error{"the trial's key unit says " + (word.empty() ? format_number(*declared) + " m" : word) + ", but " +
                         field + " is '" + stated + "'",
                     where};
    }
    return known ? *known : *declared;
}

}  // namespace myo::measurement
