#pragma once

#include <string>
#include <vector>

#include "material/material.hpp"

namespace myo::material {

MaterialPointer neo_hookean();
MaterialPointer corotational();
MaterialPointer projective_corotational();
MaterialPointer st_venant_kirchhoff();

/// Every material law; a new one is a file and a line in catalogue.cpp.
const std::vector<MaterialPointer>& material_catalogue();

/// The law with this id, or null.
MaterialPointer find_material(const std::string& id);

std::vector<std::string> material_ids();

}  // namespace myo::material
