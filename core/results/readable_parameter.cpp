#include "results/readable_parameter.hpp"

#include <numbers>

#include "setup/actuator_signals.hpp"

namespace myo::results {
namespace {

/// "effect.point_mass.position_m.x" -> "Point mass, position x" in mm.
ReadableParameter readable_number_of_effect(const prediction::ModelParameter& p) {
    // Names of effect parameters are effect.<id>.<parameter>[.<component>].
    std::string id = p.parameter.name;
    if (id.starts_with("effect.")) id = id.substr(7, id.find('.', 7) - 7);
    ReadableParameter shown = readable_quantity(p.of_effect);
    shown.name = effect_name(id) + ", " + shown.name;
    // Two angles per direction, numbered from 1.
    if (p.is_angle()) return {shown.name + " turned " + std::to_string(p.component + 1), "°", 180.0 / std::numbers::pi};
    if (p.component >= 0) shown.name += std::string(" ") + "xyz"[p.component % 3];
    return shown;
}

}  // namespace

ReadableParameter readable_parameter(const prediction::ModelParameter& p, const setup::Setup& setup) {
    using Kind = prediction::ModelParameter::Kind;
    // The index of a translation or rotation is its axis; of other kinds the word is not used.
    const std::string axis(1, "xyz"[p.index % 3]);
    switch (p.kind) {
        case Kind::youngs_modulus: return {"Young's modulus E", "kPa", 1e-3};
        case Kind::damping: return {"Damping time", "ms", 1e3};
        case Kind::law: {
            const material::LawParameter law = setup.trials.front().model.material->parameters()[p.index];
            return {law.label, law.unit, 1.0};
        }
        case Kind::translation: return {"Camera shift " + axis, "mm", 1e3};
        case Kind::rotation: return {"Camera turn about " + axis, "°", 180.0 / std::numbers::pi};
        case Kind::start_shift: return {"Later start of " + setup.trials[p.trial].name, "ms", 1e3};
        case Kind::effect: return readable_number_of_effect(p);
        case Kind::part_modulus: return {"Young's modulus of " + setup.experiment.parts[p.index].name, "kPa", 1e-3};
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
