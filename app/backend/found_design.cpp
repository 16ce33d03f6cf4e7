#include "backend/found_design.hpp"

#include <algorithm>
#include <limits>

#include "backend/core_scene.hpp"
#include "backend/declaration.hpp"
#include "toml/toml_text.hpp"

namespace myo::backend {
namespace {

using calibration::FoundItem;
using calibration::SoughtKind;
using ui::commands::SetDeclared;

/// Index in the declaration of the muscle that one of the settings comes from; their number if there is none. Order and
/// names may differ from the settings, where muscles are renamed, added and removed.
std::size_t declared_index(const ui::commands::Scene& scene, const std::string& name) {
    const auto& muscles = source_of(scene).experiment.muscles;
    const auto found = std::find_if(muscles.begin(), muscles.end(),
                                    [&](const auto& each) { return each.name == name; });
    return static_cast<std::size_t>(found - muscles.begin());
}

}  // namespace

Result<ui::commands::Settings> with_found_design(ui::commands::Settings settings, const ui::commands::Scene& scene,
                                                 const std::vector<FoundItem>& found) {
    std::vector<ui::commands::DeclarationEdit> edits;
    for (const FoundItem& item : found) {
        if (item.item.kind == SoughtKind::modulus) {
            if (item.item.of.empty())
                settings.youngs_modulus_Pa = item.youngs_modulus_Pa;
            else
                edits.push_back(
                    SetDeclared{{"part", item.index, "youngs_modulus_Pa"}, toml::toml_number(item.youngs_modulus_Pa)});
            continue;
        }
        ui::commands::Muscle& muscle = settings.muscles[item.index];
        // A mask has weights and directions and goes with the settings; a single direction is a key of the declaration.
        if (item.mask)
            muscle.paint = item.mask;
        else if (item.fibre)
            edits.push_back(SetDeclared{{"muscle", declared_index(scene, muscle.declared), "fibre"},
                                        toml::toml_vector(*item.fibre)});
    }
    // An edit of the declaration makes the window read the experiment again.
    if (edits.empty()) return settings;
    Result<ui::commands::Declaration> declaration = edited_declaration(scene, settings.declaration, edits);
    if (!declaration) return declaration.error();
    settings.declaration = *std::move(declaration);
    return settings;
}

std::vector<ui::commands::ParameterRow> design_rows(const std::vector<FoundItem>& found) {
    std::vector<ui::commands::ParameterRow> rows;
    for (const FoundItem& item : found)
        rows.push_back({calibration::readable(item.item), item.unit, item.before, item.after,
                        std::numeric_limits<double>::quiet_NaN()});
    return rows;
}

std::vector<ui::commands::SeekChoice> seek_choices(const experiment::Experiment& experiment) {
    std::vector<ui::commands::SeekChoice> choices;
    for (const calibration::SoughtItem& item : calibration::seekable_items(experiment))
        if (item.kind != SoughtKind::signals) {
            std::string label = calibration::readable(item);
            label.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(label.front())));
            choices.push_back(
                {calibration::to_string(item), std::move(label), item.kind == SoughtKind::modulus ? "" : item.of});
        }
    return choices;
}

}  // namespace myo::backend
