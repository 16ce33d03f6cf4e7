#pragma once

#include <string>
#include <vector>

#include "material/material.hpp"
#include "toml/toml_reader.hpp"

namespace myo::experiment {

/// Values of the law's parameters from the table [material], in the law's order.
///
/// Errors: a missing or impossible value; a parameter of another law.
std::vector<double> read_law_values(const toml::TomlReader& table, const material::Material& law);

/// The lines `key = value` of a law with these values; empty for a law without parameters.
std::string law_values_text(const material::Material& law, const std::vector<double>& values);

}  // namespace myo::experiment
