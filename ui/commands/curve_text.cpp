#include "commands/curve_text.hpp"

#include "toml/toml_text.hpp"

namespace myo::ui::commands {

std::string curve_text(const fibre::Signal& curve) {
    std::string text;
    for (std::size_t row = 0; row < curve.times_s.size(); ++row)
        text += (row > 0 ? ", [" : "[") + toml::toml_number(curve.times_s[row]) + ", " +
                toml::toml_number(curve.values[row]) + "]";
    return "[" + text + "]";
}

}  // namespace myo::ui::commands
