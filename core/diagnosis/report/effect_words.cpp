#include "diagnosis/report/effect_words.hpp"

#include "base/text.hpp"

namespace myo::diagnosis {
namespace {

/// Value of a parameter: number, name, or list in brackets.
std::string words(const effect::EffectParameter& value) {
    if (const auto* const number = std::get_if<double>(&value)) return format_number(*number, 6);
    if (const auto* const name = std::get_if<std::string>(&value)) return *name;
    std::string list;
    if (const auto* const names = std::get_if<std::vector<std::string>>(&value)) {
        for (const std::string& name : *names) list += (list.empty() ? "" : ", ") + name;
    } else {
        for (const double number : std::get<Eigen::VectorXd>(value))
            list += (list.empty() ? "" : ", ") + format_number(number, 6);
    }
    return "[" + list + "]";
}

}  // namespace

std::string parameter_words(const effect::EffectParameters& parameters) {
    std::string list;
    for (const auto& [name, value] : parameters) list += (list.empty() ? "" : ", ") + name + " = " + words(value);
    return list;
}

std::string effect_words(const effect::EffectDeclaration& effect) {
    return effect.id + " (" + parameter_words(effect.parameters) + ")";
}

}  // namespace myo::diagnosis
