#include "panels/tendon_panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "panels/command_rows.hpp"
#include "platform/fonts.hpp"
#include "toml/toml_text.hpp"

namespace myo::ui::panels {
namespace {

/// Values of what is added, for the user to change.
struct NewTendonPolicy {
    double stiffness_N_m = 1e4;  // of a nylon thread of decimetres
};
constexpr NewTendonPolicy new_tendon_policy;

/// The path [m] without one of its guides.
Eigen::Matrix3Xd without_guide(const Eigen::Matrix3Xd& path_m, Eigen::Index guide) {
    Eigen::Matrix3Xd left(3, path_m.cols() - 1);
    left << path_m.leftCols(guide), path_m.rightCols(path_m.cols() - guide - 1);
    return left;
}

}  // namespace

void TendonPanel::draw(PanelContext& context) {
    const auto& tendons = context.state.scene->declared.tendons;
    draw_new(context);
    if (tendons.empty()) {
        muted_text(context.theme,
                   "A tendon is a thread that a motor pulls through guides on the body; between guides it is "
                   "straight.");
    } else {
        // Undo may have removed the last tendons.
        chosen_ = std::min(chosen_, tendons.size() - 1);
        for (std::size_t t = 0; t < tendons.size(); ++t) {
            if (ImGui::Selectable((tendons[t].name + "##tendon").c_str(), t == chosen_)) chosen_ = t;
            context.items.mark("tendon/list/" + tendons[t].name);
        }
        draw_tendon(context, chosen_);
    }
}

void TendonPanel::draw_new(PanelContext& context) {
    const bool drawing = context.placing.sets(Placing::Kind::guides) && context.placing.tendon < 0;
    ImGui::BeginDisabled(!context.state.body);
    if (toggle_button(context.theme, drawing ? "Drawing a tendon\xe2\x80\xa6" : "Add by clicking##tendon", drawing)) {
        context.placing = {};
        if (!drawing) context.placing.kind = Placing::Kind::guides;
        // The new tendon will be the last one; until it exists, draw() clamps the index.
        chosen_ = context.state.scene->declared.tendons.size();
    }
    ImGui::EndDisabled();
    context.items.mark("tendon/add");
    tooltip(context.theme, context.state.body ? "Click the guides along the body, the motor's end first. Enter ends "
                                                "the tendon, Escape drops it."
                                              : "Build the mesh first.");
    if (!drawing) return;
    bool goes_on = false;
    const NumberField field{"Depth",
                            "tendon/depth",
                            commands::Dimension::length,
                            "mm",
                            "Of the next guides below the surface that is clicked.",
                            {0.0, 1.0},
                            0.05};
    number_row(context, field, edits_, depth_m_, goes_on);
    // Handed over in each frame: the depth may be changed between two clicks.
    context.placing.depth_m = depth_m_;
}

void TendonPanel::draw_tendon(PanelContext& context, std::size_t t) {
    const commands::Scene& scene = *context.state.scene;
    const DeclaredActuator tendon = declared_tendon(scene, t);
    std::string name = tendon.name;
    if (names_.row(context, "Name", "tendon/name", "Heads its column in actuation files.", name))
        rename_actuator(context, tendon, name);
    draw_drive(context, t);
    command_rows(context, tendon, "tendon/command", edits_);
    draw_guides(context, t);
    if (ImGui::Button("Remove the tendon", {-1.0f, 0.0f})) remove_actuator(context, tendon);
    context.items.mark("tendon/remove");
}

void TendonPanel::draw_drive(PanelContext& context, std::size_t t) {
    const commands::DeclaredTendon& tendon = context.state.scene->declared.tendons[t];
    std::string drive = tendon.by_shortening ? "shortening" : "tension";
    const std::string before = drive;
    if (choice_row(context, "Motor prescribes", "tendon/drive", "What the command of a trial is.",
                   {{"tension", "Tension", "The force in the thread at the motor."},
                    {"shortening", "Shortening", "The length that the motor has taken in."}},
                   drive) &&
        drive != before)
        set_tendon_drive(context, t, drive == "shortening");
    // One number of the tendon, as an edit with the name of its field.
    const auto set = [&](const NumberField& field, const char* key, double value, bool goes_on) {
        context.emit(commands::EditDeclaration{
            {commands::SetDeclared{{"tendon", t, key}, toml::toml_number(value)}}, field.name, goes_on});
    };
    if (tendon.by_shortening) {
        // A thread that stretches is a spring of its whole length in series with the motor. Under a prescribed tension
        // its stretch does not matter.
        bool stretches = tendon.stiffness_N_m.has_value();
        row_label(context.theme, "Stretches", "Not ticked: the thread keeps its length.");
        if (ImGui::Checkbox("##tendon/stretches", &stretches)) {
            const toml::TomlPath path{"tendon", t, "stiffness_N_m"};
            const commands::DeclarationEdit edit = stretches
                                                       ? commands::DeclarationEdit(commands::SetDeclared{
                                                             path, toml::toml_number(new_tendon_policy.stiffness_N_m)})
                                                       : commands::RemoveDeclared{path};
            context.emit(commands::EditDeclaration{{edit}, "tendon/stretches"});
        }
        context.items.mark("tendon/stretches");
    }
    bool channel = tendon.channel;
    row_label(context.theme, "In a channel",
              "Ticked: it follows the material between its guides. Not ticked: it is straight between them.");
    if (ImGui::Checkbox("##tendon/channel", &channel)) {
        const toml::TomlPath path{"tendon", t, "channel"};
        const commands::DeclarationEdit edit = channel ? commands::DeclarationEdit(commands::SetDeclared{path, "true"})
                                                       : commands::RemoveDeclared{path};
        context.emit(commands::EditDeclaration{{edit}, "tendon/channel"});
    }
    context.items.mark("tendon/channel");
    bool goes_on = false;
    if (tendon.stiffness_N_m) {
        double stiffness = *tendon.stiffness_N_m;
        const NumberField field{"Stiffness",
                                "tendon/stiffness",
                                commands::Dimension::stiffness,
                                "N/m",
                                "Tension per elongation of the whole thread.",
                                {1e-3, 1e9},
                                10.0};
        if (number_row(context, field, edits_, stiffness, goes_on, tendon.name))
            set(field, "stiffness_N_m", stiffness, goes_on);
    }
    // T_out = T_in exp(-mu b) at a guide where the thread bends by b (capstan equation, Euler and Eytelwein).
    double friction = tendon.friction;
    const NumberField field{
        "Friction",
        "tendon/friction",
        commands::Dimension::number,
        "",
        "Capstan coefficient \xce\xbc at the guides: the tension falls by exp(\xe2\x88\x92\xce\xbc b) "
        "on every bend by b rad.",
        {0.0, 5.0},
        0.005};
    if (number_row(context, field, edits_, friction, goes_on, tendon.name)) set(field, "friction", friction, goes_on);
}

void TendonPanel::draw_guides(PanelContext& context, std::size_t t) {
    const Eigen::Matrix3Xd& path_m = context.state.scene->declared.tendons[t].path_m;
    heading(context.theme, "Guides x, y, z, motor's end first");
    const bool dragging = context.placing.sets(Placing::Kind::guides) && context.placing.tendon == static_cast<int>(t);
    ImGui::BeginDisabled(!context.state.body);
    // The same tool as for a new tendon, but with the guides of this one.
    if (toggle_button(context.theme, dragging ? "End dragging guides" : "Drag guides in the view", dragging)) {
        context.placing = {};
        if (!dragging) context.placing.kind = Placing::Kind::guides, context.placing.tendon = static_cast<int>(t);
    }
    ImGui::EndDisabled();
    context.items.mark("tendon/drag");
    // Three coordinates and the button that removes the guide share a line.
    const float button = ImGui::GetFrameHeight(), gap = ImGui::GetStyle().ItemSpacing.x;
    const float width = std::floor((ImGui::GetContentRegionAvail().x - button - 3.0f * gap) / 3.0f);
    for (Eigen::Index g = 0; g < path_m.cols(); ++g) {
        const std::string item = "tendon/guide/" + std::to_string(g);
        ImGui::PushID(item.c_str());
        for (Eigen::Index k = 0; k < 3; ++k) {
            Eigen::Matrix3Xd changed = path_m;
            bool goes_on = false;
            const NumberField field{std::string("Guide ") + axis_names[static_cast<std::size_t>(k)],
                                    item + "/" + axis_names[static_cast<std::size_t>(k)],
                                    commands::Dimension::length,
                                    "mm",
                                    "Place of the guide at rest [m].",
                                    {-10.0, 10.0},
                                    0.05};
            ImGui::SetNextItemWidth(width);
            if (number_field(context, field, edits_, changed(k, g), goes_on,
                             context.state.scene->declared.tendons[t].name))
                // The path is one value of the declaration, so each coordinate rewrites all guides.
                set_tendon_path(context, t, changed, field.name, goes_on);
            ImGui::SameLine();
        }
        // A thread needs two ends.
        ImGui::BeginDisabled(path_m.cols() <= 2);
        if (ImGui::Button(platform::icon::remove, {button, 0.0f}))
            set_tendon_path(context, t, without_guide(path_m, g), item + "/remove");
        ImGui::EndDisabled();
        context.items.mark(item + "/remove");
        tooltip(context.theme, "Remove the guide");
        ImGui::PopID();
    }
}

}  // namespace myo::ui::panels
