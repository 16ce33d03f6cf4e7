#include "effect/effect.hpp"

namespace myo::effect {

// Names as in files and reports.
std::string to_string(EffectKind kind) {
    switch (kind) {
        case EffectKind::force: return "force";
        case EffectKind::support: return "support";
        case EffectKind::material: return "material";
        case EffectKind::actuation: return "actuation";
        case EffectKind::measurement: return "measurement";
    }
    return {};
}

const EffectParameterEntry* Effect::parameter(const std::string& name) const {
    for (const EffectParameterEntry& entry : parameters)
        if (entry.name == name) return &entry;
    return nullptr;
}

// A missing parameter or one of another type is an error of the caller: at() and get() throw.
double number(const EffectParameters& parameters, const std::string& name) {
    const EffectParameter& value = parameters.at(name);
    // A number_or_vector3 may be either; its magnitude is what amounts are compared by.
    if (const auto* const v = std::get_if<Eigen::VectorXd>(&value)) return v->norm();
    return std::get<double>(value);
}

Eigen::Vector3d vector(const EffectParameters& parameters, const std::string& name) {
    return std::get<Eigen::VectorXd>(parameters.at(name));
}

std::string text(const EffectParameters& parameters, const std::string& name) {
    return std::get<std::string>(parameters.at(name));
}

bool has(const EffectParameters& parameters, const std::string& name) { return parameters.count(name) > 0; }

// Effects without the parameter `trial` act on all trials.
bool acts_on(const TrialContext& context, const EffectParameters& parameters) {
    return !has(parameters, "trial") || text(parameters, "trial") == context.trial;
}

std::vector<std::string> fitted_names(const EffectDeclaration& effect, const EffectParameterEntry& parameter) {
    const auto found = effect.parameters.find(parameter.name);
    if (found == effect.parameters.end() || !(parameter.scale > 0.0)) return {};
    const std::string name = "effect." + effect.id + "." + parameter.name;
    const auto* const v = std::get_if<Eigen::VectorXd>(&found->second);
    if (v == nullptr) return {name};
    if (parameter.kind == EffectParameterKind::direction) return {name + ".turn_1_rad", name + ".turn_2_rad"};
    std::vector<std::string> names;
    for (Eigen::Index i = 0; i < v->size(); ++i)
        names.push_back(name + "." +
                        (parameter.kind == EffectParameterKind::number_or_list ? "trial_" + std::to_string(i + 1)
                                                                               : std::string(1, "xyz"[i % 3])));
    return names;
}

EffectProbe probe(EffectParameters at, const std::string& amount) { return {{std::move(at)}, amount, false, nullptr}; }

EffectParameterEntry fitted_number(const std::string& name, double lowest, double highest, double scale,
                                   bool over_decades) {
    return {name, EffectParameterKind::number, false, lowest, highest, scale, over_decades};
}

}  // namespace myo::effect
