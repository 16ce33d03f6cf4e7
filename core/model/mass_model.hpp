#pragma once

#include <string>
#include <vector>

namespace myo::model {

/// Discretisation of the mass.
enum class MassModel {
    consistent,  // integrals of the shape functions: exact total mass
    // Density times mean cell volume at every vertex, independent of its cells. Published scheme, for comparison: mass
    // and weight of the body have an error of vertices over cells (136 % for 23 x 7 x 7 hexahedra).
    equal_vertices,
};

/// Name of the mass model in files and on the command line.
std::string to_string(MassModel model);
/// All names.
std::vector<std::string> mass_model_ids();
/// Looks up a mass model by name. Returns false if unknown; `model` is then unchanged.
bool parse_mass_model(const std::string& id, MassModel& model);

}  // namespace myo::model
