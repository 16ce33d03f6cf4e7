#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/text.hpp"
#include "effect/catalogue.hpp"
#include "experiment/actuators.hpp"
#include "experiment/read_experiment.hpp"
#include "experiment/read_experiment_tables.hpp"
#include "material/catalogue.hpp"

namespace myo::experiment {
namespace {

/// Names of the values that a fit can find.
std::vector<std::string> names_of_unknowns(const Experiment& experiment) {
    std::vector<std::string> names{"youngs_modulus_Pa", "damping_s"};
    for (const material::LawParameter& parameter : material::find_material(experiment.material.model)->parameters())
        names.push_back(parameter.name);
    for (const PartDeclaration& part : experiment.parts)
        for (const char* value : {".youngs_modulus_Pa", ".damping_s"}) names.push_back(part.name + value);
    for (const char axis : {'x', 'y', 'z'}) {
        names.push_back(std::string("registration_") + axis + "_m");
        names.push_back(std::string("registration_rotation_") + axis + "_rad");
    }
    for (const TrialDeclaration& trial : experiment.trials) {
        names.push_back("start_shift_s." + trial.name);
        for (const Actuator& actuator : actuators(experiment))
            names.push_back("actuation_level." + trial.name + "." + actuator.name);
    }
    for (const effect::EffectDeclaration& effect : experiment.effects)
        for (const effect::EffectParameterEntry& parameter : effect::find_effect(effect)->parameters)
            for (std::string& name : effect::fitted_names(effect, parameter)) names.push_back(std::move(name));
    return names;
}

}  // namespace

std::vector<UnknownDeclaration> read_unknowns(const toml::TomlReader& document) {
    std::vector<UnknownDeclaration> unknowns;
    for (const toml::TomlReader& table : document.tables("unknown", {"name", "lowest", "highest", "tolerance"})) {
        UnknownDeclaration unknown{table.text("name"), table.optional_number("lowest"),
                                   table.optional_number("highest"),
                                   table.optional_number("tolerance", toml::positive())};
        // Two tables for one value would contradict each other.
        for (const UnknownDeclaration& other : unknowns)
            if (other.name == unknown.name)
                table.fail("name", "the bounds of \"" + unknown.name + "\" are declared already");
        if (unknown.tolerance)
            for (const char* key : {"lowest", "highest"})
                table.reject(key, "cannot be combined with tolerance, which bounds the value on both sides");
        if (unknown.lowest && unknown.highest && !(*unknown.lowest < *unknown.highest))
            table.fail("lowest", "is not below highest (" + format_number(*unknown.lowest) + ", " +
                                     format_number(*unknown.highest) + ")");
        // A fit that reaches a modulus of zero could not be simulated.
        if (unknown.name.ends_with("youngs_modulus_Pa"))
            for (const auto& [key, bound] :
                 {std::pair{"lowest", unknown.lowest}, std::pair{"highest", unknown.highest}})
                if (bound && !(*bound > 0.0)) table.fail(key, "must be positive: it bounds a modulus");
        unknowns.push_back(std::move(unknown));
    }
    return unknowns;
}

/// The modulus that a name means, as declared [Pa]; empty: it means another value.
static std::optional<double> declared_modulus_Pa(const Experiment& experiment, const std::string& name) {
    if (name == "youngs_modulus_Pa") return experiment.material.youngs_modulus_Pa;
    for (const PartDeclaration& part : experiment.parts)
        if (name == part.name + ".youngs_modulus_Pa") return part.youngs_modulus_Pa;
    return std::nullopt;
}

void check_unknowns(const Experiment& experiment) {
    const std::vector<std::string> names = names_of_unknowns(experiment);
    for (std::size_t i = 0; i < experiment.unknowns.size(); ++i) {
        const UnknownDeclaration& unknown = experiment.unknowns[i];
        // The lower bound is the declared modulus less the tolerance.
        const std::optional<double> modulus = declared_modulus_Pa(experiment, unknown.name);
        if (modulus && unknown.tolerance && !(*unknown.tolerance < *modulus))
            throw toml::TomlFailure{declaration_error(
                experiment, "unknown[" + std::to_string(i) + "].tolerance",
                "must be below the modulus, " + format_number(*modulus) + " Pa, or the modulus could be zero")};
    }
    for (std::size_t i = 0; i < experiment.unknowns.size(); ++i) {
        const std::string& name = experiment.unknowns[i].name;
        if (std::find(names.begin(), names.end(), name) != names.end()) continue;
        const std::string key = "unknown[" + std::to_string(i) + "].name";
        throw toml::TomlFailure{declaration_error(experiment, key,
                                                  "no fit finds a value \"" + name +
                                                      "\"; names are those of the results, such as \"" + names.front() +
                                                      "\"")};
    }
}

}  // namespace myo::experiment
