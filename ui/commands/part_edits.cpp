#include "commands/part_edits.hpp"

#include <algorithm>

#include "toml/toml_text.hpp"

namespace myo::ui::commands {
namespace {

/// A name that no part has: "part", "part_2".
std::string free_part_name(const Scene& scene) {
    std::string name = "part";
    const auto taken = [&](const ScenePart& part) { return part.name == name; };
    for (int k = 2; std::any_of(scene.parts.begin(), scene.parts.end(), taken); ++k) name = "part_" + std::to_string(k);
    return name;
}

}  // namespace

std::string new_part(const WorkbenchState& state, const std::string& place) {
    const std::string line = place.empty() ? "" : place + "\n";
    return "name = " + toml::toml_text(free_part_name(*state.scene)) + "\n" + line +
           "youngs_modulus_Pa = " + toml::toml_number(state.settings.youngs_modulus_Pa) + "\n";
}

const char* place_key(const ScenePart& part) {
    if (part.box_m) return "box_m";
    if (part.region) return "region";
    return part.file.empty() ? "mask" : "file";
}

std::string declared_file(const Scene& scene, const std::filesystem::path& file) {
    std::error_code code;
    const std::filesystem::path opened = std::filesystem::absolute(scene.path, code),
                                folder = opened.extension() == ".toml" ? opened.parent_path() : opened,
                                within = file.lexically_relative(folder);
    const bool outside = within.empty() || *within.begin() == "..";
    return toml::toml_text((outside ? file : within).generic_string());
}

}  // namespace myo::ui::commands
