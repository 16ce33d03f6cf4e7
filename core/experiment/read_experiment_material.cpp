#include <algorithm>

#include "experiment/law_values.hpp"
#include "experiment/read_experiment_tables.hpp"
#include "material/catalogue.hpp"

namespace myo::experiment {
namespace {

/// Parameters to fit: of youngs_modulus, damping, actuation_level and the law's own, each at most once.
std::vector<std::string> read_calibrate(const toml::TomlReader& material, const material::Material& law) {
    std::vector<std::string> calibratable = {"youngs_modulus", "damping", "actuation_level"};
    for (const material::LawParameter& parameter : law.parameters()) calibratable.push_back(parameter.name);
    std::vector<std::string> names = material.texts("calibrate");
    for (auto name = names.begin(); name != names.end(); ++name) {
        if (std::find(calibratable.begin(), calibratable.end(), *name) == calibratable.end())
            material.fail("calibrate", "unknown parameter \"" + *name + "\"; " + toml::suggest(*name, calibratable));
        if (std::find(names.begin(), name, *name) != name) material.fail("calibrate", "names \"" + *name + "\" twice");
    }
    return names;
}

/// Keys of [material] for any law. read_law_values() then refuses those of laws other than the declared one, with a
/// better message than that of an unknown key.
std::vector<std::string> material_keys() {
    std::vector<std::string> keys = {"model",          "youngs_modulus_Pa", "youngs_modulus_tolerance",
                                     "poissons_ratio", "density_kg_m3",     "damping_s",
                                     "calibrate"};
    for (const material::LawParameter& parameter : material::all_law_parameters()) keys.push_back(parameter.name);
    return keys;
}

}  // namespace

MaterialDeclaration read_material(const toml::TomlReader& document) {
    const toml::TomlReader material = document.table("material", material_keys());
    MaterialDeclaration declared;
    declared.model = material.text("model");
    const material::MaterialPointer law = material::find_material(declared.model);
    if (law == nullptr)
        material.fail("model", "unknown material model \"" + declared.model + "\"; " +
                                   toml::suggest(declared.model, material::material_ids()));
    declared.youngs_modulus_Pa = material.number("youngs_modulus_Pa", toml::positive());
    declared.youngs_modulus_tolerance = material.number_or("youngs_modulus_tolerance",
                                                           declared.youngs_modulus_tolerance, toml::not_negative());
    if (declared.youngs_modulus_tolerance >= 1.0)
        material.fail("youngs_modulus_tolerance",
                      "is a relative half-width and must be below 1, or the modulus could be zero");
    declared.poissons_ratio = material.number("poissons_ratio", toml::strictly_between(0.0, 0.5));
    declared.density_kg_m3 = material.number("density_kg_m3", toml::positive());
    declared.damping_s = material.optional_number("damping_s", toml::not_negative());
    declared.law = read_law_values(material, *law);
    if (material.has("calibrate")) declared.calibrate = read_calibrate(material, *law);
    const auto& names = declared.calibrate;
    // Damping is either fitted or given: an unknown value that is not fitted would silently be a default.
    if (!declared.damping_s && std::find(names.begin(), names.end(), "damping") == names.end())
        material.fail("calibrate", "\"damping\" is left out, so its exact value must be given as material.damping_s");
    return declared;
}

}  // namespace myo::experiment
