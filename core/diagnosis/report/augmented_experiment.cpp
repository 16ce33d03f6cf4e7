#include "diagnosis/report/augmented_experiment.hpp"

#include <cstdio>

#include "experiment/effect_toml.hpp"
#include "experiment/experiment_text.hpp"
#include "toml/toml_text.hpp"

namespace myo::diagnosis {
namespace {

/// Number with the digits that a fit determines at most, for a file that people read.
std::string short_number(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.8g", value);
    // TOML distinguishes integers: 3 is not 3.0.
    return std::string(text).find_first_of(".e") == std::string::npos ? std::string(text) + ".0" : std::string(text);
}

}  // namespace

std::string effect_tables(const std::vector<effect::EffectDeclaration>& effects, bool calibrate) {
    std::string text;
    for (const effect::EffectDeclaration& effect : effects) {
        text += "\n[[effect]]\nid = " + toml::toml_text(effect.id) + "\n";
        for (const auto& [name, value] : effect.parameters)
            text += name + " = " + experiment::effect_toml(value, short_number) + "\n";
        if (calibrate) text += "calibrate = true\n";
    }
    return text;
}

Result<std::string> augmented_experiment(const std::filesystem::path& written,
                                         const std::vector<effect::EffectDeclaration>& effects,
                                         const std::filesystem::path& folder) {
    Result<std::string> text = experiment::experiment_text_for(folder, written);
    if (!text) return text.error();
    if (!effects.empty())
        *text +=
            "\n# Found by `myoloop diagnose`. Modulus and damping stay as declared: `myoloop calibrate` fits them "
            "together with what follows.";
    return *text + effect_tables(effects, true);
}

}  // namespace myo::diagnosis
