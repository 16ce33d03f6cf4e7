#include "experiment/read_experiment_tables.hpp"

namespace myo::experiment {

std::vector<ChamberDeclaration> read_chambers(const toml::TomlReader& document) {
    std::vector<ChamberDeclaration> chambers;
    for (const toml::TomlReader& table : document.tables("chamber", {"name", "inside_m", "sought"}))
        chambers.push_back({read_actuator_name(table), table.vector3("inside_m"), table.boolean_or("sought", true)});
    return chambers;
}

}  // namespace myo::experiment
