#pragma once

#include <string>
#include <vector>

namespace myo::model {

/// How a density becomes the mass matrix of a body.
enum class MassModel {
    consistent,      // integrals of the shape functions: the body's true mass
    equal_vertices,  // every vertex gets density x mean cell volume, whatever it touches. As published, for comparison:
                     // the body's mass, and with it its weight, is wrong by vertices over cells (136 % for 23 x 7 x 7
                     // hexahedra)
};

std::string to_string(MassModel model);
std::vector<std::string> mass_model_ids();
/// False when there is no model of this name.
bool parse_mass_model(const std::string& id, MassModel& model);

}  // namespace myo::model
