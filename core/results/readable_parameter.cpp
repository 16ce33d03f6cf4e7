#include "results/readable_parameter.hpp"

#include <algorithm>
#include <cctype>
#include <numbers>
#include <string_view>

#include "setup/actuator_signals.hpp"

namespace myo::results {
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

/// "effect.point_mass.position_m.x" -> "Point mass, position x" in mm.
ReadableParameter readable_number_of_effect(const prediction::ModelParameter& p) {
    std::string id = p.parameter.name;
    if (id.starts_with("effect.")) id = id.substr(7, id.find('.', 7) - 7);
    ReadableParameter shown = readable_quantity(p.of_effect);
    shown.name = effect_name(id) + ", " + shown.name;
    if (p.is_angle()) return {shown.name + " turned " + std::to_string(p.component + 1), "°", 180.0 / std::numbers::pi};
    if (p.component >= 0) shown.name += std::string(" ") + "xyz"[p.component % 3];
    return shown;
}

}  // namespace

std::string effect_name(const std::string& id) {
    std::string name = spaced(id);
    if (!name.empty()) name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
    return name;
}

ReadableParameter readable_quantity(const std::string& name) {
    for (const UnitSuffix& known : unit_suffixes)
        if (name.ends_with(known.suffix)) {
            const bool is_unit = known.suffix[0] == '_';
            return {spaced(is_unit ? name.substr(0, name.size() - std::string_view(known.suffix).size()) : name),
                    known.unit, known.factor};
        }
    return {spaced(name), "", 1.0};
}

ReadableParameter readable_parameter(const prediction::ModelParameter& p, const setup::Setup& setup) {
    using Kind = prediction::ModelParameter::Kind;
    const std::string axis(1, "xyz"[p.index % 3]);
    switch (p.kind) {
        case Kind::youngs_modulus: return {"Young’s modulus E", "kPa", 1e-3};
        case Kind::damping: return {"Damping time", "ms", 1e3};
        case Kind::law: {
            const material::LawParameter law = setup.trials.front().model.material->parameters()[p.index];
            return {law.label, law.unit, 1.0};
        }
        case Kind::translation: return {"Camera shift " + axis, "mm", 1e3};
        case Kind::rotation: return {"Camera turn about " + axis, "°", 180.0 / std::numbers::pi};
        case Kind::start_shift: return {"Later start of " + setup.trials[p.trial].name, "ms", 1e3};
        case Kind::effect: return readable_number_of_effect(p);
        case Kind::part_modulus: return {"Young’s modulus of " + setup.experiment.parts[p.index].name, "kPa", 1e-3};
        case Kind::part_damping: return {"Damping time of " + setup.experiment.parts[p.index].name, "ms", 1e3};
        case Kind::level: {
            const std::string unit = setup::signal_unit(setup.experiment, p.index);
            return {
                "Level of " + setup::actuator_names(setup.experiment)[p.index] + " in " + setup.trials[p.trial].name,
                unit == "Pa" ? "kPa" : unit, unit == "Pa" ? 1e-3 : 1.0};
        }
    }
    return {p.parameter.name, p.unit, 1.0};
}

}  // namespace myo::results
