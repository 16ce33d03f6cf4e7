#include "backend/effect_settings.hpp"

#include <type_traits>
#include <variant>

#include "base/text.hpp"
#include "results/readable_parameter.hpp"

namespace myo::backend {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// "coefficient 903 kg/m³, position 1, 2, 3 mm".
std::string readable_words(const effect::EffectParameters& parameters) {
    std::string words;
    for (const auto& [name, value] : parameters) {
        const results::ReadableParameter shown = results::readable_quantity(name);
        std::string text;
        if (const auto* const number = std::get_if<double>(&value)) text = format_number(shown.factor * *number, 4);
        if (const auto* const word = std::get_if<std::string>(&value)) text = *word;
        if (const auto* const several = std::get_if<std::vector<std::string>>(&value)) text = join(*several);
        if (const auto* const v = std::get_if<VectorXd>(&value))
            for (const double number : *v) text += (text.empty() ? "" : ", ") + format_number(shown.factor * number, 4);
        words += (words.empty() ? "" : "; ") + shown.name + " " + text + (shown.unit.empty() ? "" : " " + shown.unit);
    }
    return words;
}

}  // namespace

ui::commands::AddedEffect added_effect(const effect::EffectDeclaration& effect) {
    ui::commands::AddedEffect result{effect.id, {}, results::effect_name(effect.id), readable_words(effect.parameters)};
    for (const auto& [name, value] : effect.parameters)
        result.parameters[name] = std::visit(
            []<class T>(const T& v) -> ui::commands::AddedEffect::Value {
                if constexpr (std::is_same_v<T, VectorXd>)
                    return std::vector<double>(v.begin(), v.end());
                else
                    return v;
            },
            value);
    return result;
}

effect::EffectDeclaration declaration(const ui::commands::AddedEffect& effect) {
    effect::EffectDeclaration result{effect.id, {}, true};
    for (const auto& [name, value] : effect.parameters)
        result.parameters[name] = std::visit(
            []<class T>(const T& v) -> effect::EffectParameter {
                if constexpr (std::is_same_v<T, std::vector<double>>)
                    return VectorXd(Eigen::Map<const VectorXd>(v.data(), static_cast<Index>(v.size())));
                else
                    return v;
            },
            value);
    return result;
}

}  // namespace myo::backend
