#include "backend/effect_settings.hpp"

#include <utility>
#include <variant>

#include "base/text.hpp"
#include "results/readable_parameter.hpp"

namespace myo::backend {
namespace {

using Eigen::VectorXd;

/// "coefficient 903 kg/m³, position 1, 2, 3 mm".
std::string readable_text(const effect::EffectParameters& parameters) {
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

ui::commands::AddedEffect added_effect(effect::EffectDeclaration effect) {
    effect.calibrate = true;
    std::string name = results::effect_name(effect.id), words = readable_text(effect.parameters);
    return {std::move(effect), std::move(name), std::move(words)};
}

}  // namespace myo::backend
