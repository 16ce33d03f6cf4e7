#include "panels/unknown_panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <utility>

#include "panels/unknown_bounds.hpp"
#include "toml/toml_text.hpp"

namespace myo::ui::panels {
namespace {

/// A value of the material, or the levels of the actuation, that a fit may find.
struct Unknown {
    const char* id;  // in material.calibrate
    const char* label;
    const char* tip;
};
constexpr std::array<Unknown, 3> unknowns{
    {{"youngs_modulus", "Young's modulus E", "Found within the tolerance that the experiment declares."},
     {"damping", "Damping time \xcf\x84", "Kelvin\xe2\x80\x93Voigt time of the material."},
     {"actuation_level", "Levels of the actuation", "Levels that trials declare as \"free\"."}}};

}  // namespace

void UnknownPanel::draw(PanelContext& context) {
    const std::vector<std::string>& declared = context.state.scene->unknowns;
    for (const Unknown& unknown : unknowns) {
        const auto found = std::find(declared.begin(), declared.end(), unknown.id);
        bool sought = found != declared.end();
        if (ImGui::Checkbox(unknown.label, &sought)) {
            // The list keeps its order, and ids that this panel does not know.
            std::vector<std::string> wanted = declared;
            if (sought)
                wanted.emplace_back(unknown.id);
            else
                wanted.erase(wanted.begin() + (found - declared.begin()));
            std::vector<commands::DeclarationEdit> edits{
                commands::SetDeclared{{"material", "calibrate"}, toml::toml_list(wanted, toml::toml_text)}};
            // A damping that is not sought is known: the one that the window shows.
            if (!sought && unknown.id == std::string("damping"))
                edits.push_back(commands::SetDeclared{{"material", "damping_s"},
                                                      toml::toml_number(context.state.settings.damping_s)});
            context.emit(commands::EditDeclaration{std::move(edits), std::string("unknown/") + unknown.id});
        }
        context.items.mark(std::string("unknown/") + unknown.id);
        tooltip(context.theme, unknown.tip);
    }
    draw_bounds(context, edits_);
}

}  // namespace myo::ui::panels
