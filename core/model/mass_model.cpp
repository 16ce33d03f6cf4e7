#include "model/mass_model.hpp"

#include "base/name_table.hpp"

namespace myo::model {
namespace {

// Names in files and on the command line.
constexpr NameTable<MassModel, 2> models{{{
    {MassModel::consistent, "consistent"},
    {MassModel::equal_vertices, "equal_vertices"},
}}};

}  // namespace

std::string to_string(MassModel model) { return models.name(model); }
std::vector<std::string> mass_model_ids() { return models.names(); }
bool parse_mass_model(const std::string& id, MassModel& model) { return models.find(id, model); }

}  // namespace myo::model
