#pragma once

#include <string>
#include <vector>

#include "material/material.hpp"

namespace myo::material {

/// Nearly incompressible neo-Hookean law.
MaterialPointer neo_hookean();
/// Corotational linear elasticity: small strain, large rotations.
MaterialPointer corotational();
/// Published variant without separable volume; locks near incompressibility.
MaterialPointer projective_corotational();
/// St. Venant-Kirchhoff law: small strain, large rotations; soft in compression.
MaterialPointer st_venant_kirchhoff();

/// All material laws. A new law is one file and one entry in catalogue.cpp.
const std::vector<MaterialPointer>& material_catalogue();

/// Law with the given id; null if unknown.
MaterialPointer find_material(const std::string& id);

/// Ids of all laws in the order of the catalogue.
std::vector<std::string> material_ids();

}  // namespace myo::material
