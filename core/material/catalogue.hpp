#pragma once

#include <string>
#include <vector>

#include "material/material.hpp"

namespace myo::material {

/// Nearly incompressible neo-Hookean law.
MaterialPointer neo_hookean();

/// All material laws. A new law is a file of its own and one line in catalogue.cpp.
const std::vector<MaterialPointer>& material_catalogue();

/// Law with the given id and values of its parameters; null if the id is unknown.
///
/// @param values  one for each parameter, in the order of parameters(); empty: the usual ones
MaterialPointer find_material(const std::string& id, const std::vector<double>& values = {});

/// Ids of all laws in the order of the catalogue.
std::vector<std::string> material_ids();

/// Parameters of all laws; no two laws have one of the same name.
std::vector<LawParameter> all_law_parameters();

}  // namespace myo::material
