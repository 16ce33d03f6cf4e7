#include "commands/part_edits.hpp"

#include <algorithm>
#include <tuple>

#include "toml/toml_text.hpp"

namespace myo::ui::commands {
namespace {

/// Whether two masks hold the same shares of the same cells.
bool same_cells(const fibre::PaintedMask& a, const fibre::PaintedMask& b) {
    return a.cell_size_m == b.cell_size_m && a.count() == b.count() && a.weights == b.weights &&
           a.centroids_m == b.centroids_m;
}

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

void keep_masks(const std::vector<ScenePart>& before, std::vector<ScenePart>& parts) {
    for (std::size_t k = 0; k < std::min(before.size(), parts.size()); ++k)
        if (before[k].mask && parts[k].mask && same_cells(*before[k].mask, *parts[k].mask))
            parts[k].mask = before[k].mask;
}

bool same_places(const std::vector<ScenePart>& a, const std::vector<ScenePart>& b) {
    const auto place = [](const ScenePart& part) { return std::tie(part.box_m, part.file, part.region, part.mask); };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [&](const ScenePart& x, const ScenePart& y) { return place(x) == place(y); });
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
