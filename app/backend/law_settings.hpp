#pragma once

#include <vector>

#include "commands/backend.hpp"
#include "material/material.hpp"

// Constitutive laws of the core as the workbench shows and sets them.

namespace myo::backend {

/// The laws to choose from, with the numbers that each of them has.
std::vector<ui::commands::Choice> law_choices();

/// Values of the parameters of the law of the settings, in its order; usual ones where the settings have none.
std::vector<double> law_values(const ui::commands::Settings& settings);

/// Keeps values of the parameters of the law of the settings.
void set_law_values(const std::vector<double>& values, ui::commands::Settings& settings);

}  // namespace myo::backend
