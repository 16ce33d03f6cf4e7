#pragma once

#include <string>

#include "fibre/signal.hpp"

namespace myo::ui::commands {

/// TOML text of a curve over time: rows "[t_s, value]".
std::string curve_text(const fibre::Signal& curve);

}  // namespace myo::ui::commands
