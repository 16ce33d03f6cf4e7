#pragma once

#include <vector>

#include "commands/backend.hpp"
#include "material/material.hpp"

// Constitutive laws of the core as the workbench shows and sets them.

namespace myo::backend {

/// The laws to choose from, in the order of the catalogue, with the numbers that each of them has.
std::vector<ui::commands::Choice> law_choices();

/// Values of the parameters of the law of the settings, in its order and within its bounds; usual ones where the
/// settings have none. Empty for a law without parameters or an unknown one.
std::vector<double> law_values(const ui::commands::Settings& settings);

/// Keeps values of the parameters of the law of the settings, in its order. Numbers of other laws stay.
void set_law_values(const std::vector<double>& values, ui::commands::Settings& settings);

}  // namespace myo::backend
