#include "panels/chamber_panel.hpp"

#include <imgui.h>

#include <algorithm>

#include "panels/command_rows.hpp"
#include "plot/number_text.hpp"

namespace myo::ui::panels {
namespace {

/// Volume of a cavity at rest.
std::string volume_text(const commands::SceneCavity& cavity) {
    return plot::value_label(1e6 * cavity.volume_m3, 3) + " cm\xc2\xb3";
}

/// Index of a cavity's chamber in the declaration.
std::size_t index_of(const commands::Scene& scene, const std::string& chamber) {
    const auto& names = scene.declared.chambers;
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), chamber) - names.begin());
}

}  // namespace

void ChamberPanel::draw(PanelContext& context) {
    const auto& cavities = context.state.scene->declared.cavities;
    if (cavities.empty()) {
        muted_text(context.theme,
                   "The body has no closed cavity. An air chamber is a closed surface inside that of the body, in the "
                   "same file.");
        return;
    }
    uncut(context);
    draw_pick(context);
    for (std::size_t c = 0; c < cavities.size(); ++c) draw_cavity(context, c);
}

void ChamberPanel::uncut(PanelContext& context) {
    // A cut that the user made stays; only that of the tool is undone.
    if (!cut_ || context.placing.sets(Placing::Kind::cavity)) return;
    cut_ = false;
    commands::ViewOptions view = context.state.view;
    view.clip.on = false;
    context.emit(commands::ChangeView{view});
}

void ChamberPanel::draw_pick(PanelContext& context) {
    const auto& cavities = context.state.scene->declared.cavities;
    const auto open = std::find_if(cavities.begin(), cavities.end(),
                                   [](const commands::SceneCavity& cavity) { return cavity.chamber.empty(); });
    if (open == cavities.end()) return;
    const bool picks = context.placing.sets(Placing::Kind::cavity);
    ImGui::BeginDisabled(!context.state.body);
    if (toggle_button(context.theme, "Pick in the view##chamber", picks)) {
        context.placing = {};
        if (!picks) {
            context.placing.kind = Placing::Kind::cavity;
            commands::ViewOptions view = context.state.view;
            // Walls of a cavity are inside the body: the plane goes through the first cavity that is no chamber yet.
            if (!view.clip.on) {
                view.clip.on = true;
                view.clip.position_m = view.clip.normal.dot(open->inside_m);
                context.emit(commands::ChangeView{view});
                cut_ = true;
            }
        }
    }
    ImGui::EndDisabled();
    context.items.mark("chamber/pick");
    tooltip(context.theme, "Cuts the body open until the wall of a cavity is clicked.");
}

void ChamberPanel::draw_cavity(PanelContext& context, std::size_t c) {
    const commands::Scene& scene = *context.state.scene;
    const commands::SceneCavity& cavity = scene.declared.cavities[c];
    ImGui::PushID(static_cast<int>(c));
    if (cavity.chamber.empty()) {
        if (ImGui::Button(("Make a chamber of the cavity of " + volume_text(cavity)).c_str(), {-1.0f, 0.0f}))
            add_chamber(context, cavity);
        context.items.mark("chamber/add/" + std::to_string(c));
        ImGui::PopID();
        return;
    }
    // From here on the cavity is a chamber, with a name and a command.
    const DeclaredActuator chamber = declared_chamber(scene, index_of(scene, cavity.chamber));
    const std::string item = "chamber/" + cavity.chamber;
    std::string name = cavity.chamber;
    if (names_.row(context, "Chamber", item + "/name", "Heads its column in actuation files.", name))
        rename_actuator(context, chamber, name);
    text_row(context.theme, "Volume", volume_text(cavity));
    context.items.mark(item + "/volume");
    text_row(context.theme, "Wall", plot::value_label(1e4 * cavity.area_m2, 3) + " cm\xc2\xb2");
    command_rows(context, chamber, item + "/pressure", edits_);
    if (ImGui::Button("Remove the chamber", {-1.0f, 0.0f})) remove_actuator(context, chamber);
    context.items.mark(item + "/remove");
    tooltip(context.theme, "The cavity stays in the body, without pressure.");
    ImGui::Spacing();
    ImGui::PopID();
}

}  // namespace myo::ui::panels
