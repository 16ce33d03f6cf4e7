#include "commands/place_text.hpp"

#include "toml/toml_text.hpp"

namespace myo::ui::commands {

Eigen::Vector3d written_place(const Eigen::Vector3d& place_m) {
    constexpr double per_m = 1e7;
    // Adding zero turns -0 into 0.
    return (per_m * place_m).array().round() / per_m + 0.0;
}

std::string place_text(const Eigen::Vector3d& place_m) { return toml::toml_vector(written_place(place_m)); }

}  // namespace myo::ui::commands
