#pragma once

#include <string>
#include <vector>

#include "material/material.hpp"

namespace myo::material {

/// The laws; formulas and sources are in their .cpp files.
MaterialPointer neo_hookean();
MaterialPointer corotational();
MaterialPointer projective_corotational();
MaterialPointer st_venant_kirchhoff();

/// All material laws. A new law is one file and one entry in catalogue.cpp.
const std::vector<MaterialPointer>& material_catalogue();

/// Law with the given id; null if unknown.
MaterialPointer find_material(const std::string& id);

/// Ids of all laws in the order of the catalogue.
std::vector<std::string> material_ids();

}  // namespace myo::material
