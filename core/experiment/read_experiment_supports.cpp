#include "experiment/read_experiment_tables.hpp"

namespace myo::experiment {
namespace {

/// Axes by name; without the key all three.
std::array<bool, 3> read_held(const toml::TomlReader& table) {
    if (!table.has("held")) return {true, true, true};
    std::array<bool, 3> held{};
    const std::vector<std::string> names = table.texts("held");
    if (names.empty()) table.fail("held", "names no axis, so that the support holds nothing");
    for (const std::string& name : names) {
        const std::size_t axis = std::string("xyz").find(name);
        if (name.size() != 1 || axis == std::string::npos)
            table.fail("held", "\"" + name + "\" is no axis; the axes are \"x\", \"y\" and \"z\"");
        if (held[axis]) table.fail("held", "names the axis \"" + name + "\" twice");
        held[axis] = true;
    }
    return held;
}

}  // namespace

std::vector<SupportDeclaration> read_supports(const toml::TomlReader& document) {
    std::vector<SupportDeclaration> supports;
    for (const toml::TomlReader& table : document.tables("support", {"box_m", "held"}))
        supports.push_back({table.box("box_m"), read_held(table)});
    return supports;
}

}  // namespace myo::experiment
