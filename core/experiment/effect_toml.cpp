#include "experiment/effect_toml.hpp"

namespace myo::experiment {

std::string effect_toml(const effect::EffectParameter& value, std::string (*number)(double)) {
    if (const auto* const one = std::get_if<double>(&value)) return number(*one);
    if (const auto* const name = std::get_if<std::string>(&value)) return toml::toml_text(*name);
    if (const auto* const names = std::get_if<std::vector<std::string>>(&value))
        return toml::toml_list(*names, toml::toml_text);
    return toml::toml_list(std::get<Eigen::VectorXd>(value), number);
}

}  // namespace myo::experiment
