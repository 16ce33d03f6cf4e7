#include "commands/effect_words.hpp"

#include <cassert>

#include "base/text.hpp"
#include "effect/catalogue.hpp"
#include "effect/readable_quantity.hpp"
#include "toml/toml_text.hpp"

namespace myo::ui::commands {

std::string effect_words(const effect::EffectParameters& parameters) {
    std::string words;
    for (const auto& [name, value] : parameters) {
        const effect::ReadableQuantity shown = effect::readable_quantity(name);
        std::string text;
        if (const auto* const number = std::get_if<double>(&value)) text = format_number(shown.factor * *number, 4);
        if (const auto* const word = std::get_if<std::string>(&value)) text = *word;
        if (const auto* const several = std::get_if<std::vector<std::string>>(&value)) text = join(*several);
        if (const auto* const v = std::get_if<Eigen::VectorXd>(&value))
            for (const double number : *v) text += (text.empty() ? "" : ", ") + format_number(shown.factor * number, 4);
        words += (words.empty() ? "" : "; ") + shown.name + " " + text + (shown.unit.empty() ? "" : " " + shown.unit);
    }
    return words;
}

std::string declared_text(const effect::EffectParameter& value) {
    if (const auto* const number = std::get_if<double>(&value)) return toml::toml_number(*number);
    if (const auto* const name = std::get_if<std::string>(&value)) return toml::toml_text(*name);
    if (const auto* const names = std::get_if<std::vector<std::string>>(&value))
        return toml::toml_list(*names, toml::toml_text);
    return toml::toml_list(std::get<Eigen::VectorXd>(value), toml::toml_number);
}

std::string effect_text(const effect::EffectDeclaration& effect) {
    const effect::Effect* const entry = effect::find_effect(effect);
    std::string text = "id = " + toml::toml_text(effect.id) + "\n";
    // A law that a project names has its values alone.
    if (entry == nullptr)
        for (const auto& [name, value] : effect.parameters) text += name + " = " + declared_text(value) + "\n";
    else
        for (const effect::EffectParameterEntry& parameter : entry->parameters)
            if (const auto value = effect.parameters.find(parameter.name); value != effect.parameters.end())
                text += parameter.name + " = " + declared_text(value->second) + "\n";
    return effect.calibrate ? text + "calibrate = true\n" : text;
}

std::string new_effect_text(const effect::EffectDeclaration& effect) {
    const effect::Effect* const entry = effect::find_effect(effect);
    assert(entry != nullptr);
    std::string text = "id = " + toml::toml_text(effect.id) + "\n";
    for (const effect::EffectParameterEntry& parameter : entry->parameters)
        if (!parameter.optional)
            text += parameter.name + " = " + declared_text(effect.parameters.at(parameter.name)) + "\n";
    return text;
}

}  // namespace myo::ui::commands
