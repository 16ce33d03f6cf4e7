#include "panels/part_panel.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <utility>

#include "panels/declared_list.hpp"
#include "panels/part_place_rows.hpp"
#include "toml/toml_text.hpp"

namespace myo::ui::panels {
namespace {

/// Key of a part in the declaration.
toml::TomlPath key_of(std::size_t part, const char* key) { return {"part", part, key}; }

/// A number of the part and how it is edited.
struct PartField {
    NumberField field;
    const char* key;
    double commands::ScenePart::*value;
};

/// Numbers that every part has. The name of a field is completed by that of the part.
const std::vector<PartField>& part_fields() {
    static const std::vector<PartField> fields{
        {{"Young's modulus E", "youngs_modulus", commands::Dimension::pressure, "kPa",
          "Young's modulus E [Pa] of the part.", commands::youngs_modulus_limits, 0.1, "Young's modulus"},
         "youngs_modulus_Pa",
         &commands::ScenePart::youngs_modulus_Pa},
        {{"Poisson's ratio \xce\xbd", "poissons_ratio", commands::Dimension::ratio, "",
          "Poisson's ratio of the part, dimensionless.", commands::poissons_ratio_limits, 1e-4, "Poisson's ratio"},
         "poissons_ratio",
         &commands::ScenePart::poissons_ratio},
        {{"Density \xcf\x81", "density", commands::Dimension::density, "kg/m\xc2\xb3",
          "Density [kg/m\xc2\xb3] of the "
          "part.",
          commands::density_limits, 1.0, "density"},
         "density_kg_m3",
         &commands::ScenePart::density_kg_m3}};
    return fields;
}

}  // namespace

void PartPanel::draw(PanelContext& context) {
    const commands::Scene& scene = *context.state.scene;
    if (scene.parts.empty()) muted_text(context.theme, "The whole body is of one material.");
    for (std::size_t i = 0; i < scene.parts.size(); ++i) draw_part(context, i);
    part_buttons(context, edits_);
}

void PartPanel::draw_part(PanelContext& context, std::size_t index) {
    const commands::ScenePart& part = context.state.scene->parts[index];
    const std::string item = "part/" + std::to_string(index);
    if (item_heading(context, {item, part.name, "A part with a material of its own.", "Remove the part"}) ==
        ItemPress::removed)
        context.emit(commands::EditDeclaration{{commands::RemoveDeclared{{"part", index}}}, item + "/remove"});
    if (!is_open(context, item)) return;
    draw_name(context, index);
    part_place_rows(context, index, edits_);
    draw_material(context, index);
}

void PartPanel::draw_name(PanelContext& context, std::size_t index) {
    const commands::ScenePart& part = context.state.scene->parts[index];
    const std::string item = "part/" + std::to_string(index) + "/name";
    row_label(context.theme, "Name", "Names the part's values in results.");
    // Text that is being typed belongs to one part; the others show their names.
    const bool mine = named_part_ == static_cast<std::ptrdiff_t>(index);
    std::string name = mine ? typed_name_ : part.name;
    if (ImGui::InputText("##part_name", &name)) typed_name_ = name, named_part_ = static_cast<std::ptrdiff_t>(index);
    context.items.mark(item);
    if (ImGui::IsItemDeactivatedAfterEdit() && name != part.name)
        context.emit(
            commands::EditDeclaration{{commands::SetDeclared{key_of(index, "name"), toml::toml_text(name)}}, item});
    if (!ImGui::IsItemActive()) named_part_ = -1;
}

void PartPanel::draw_material(PanelContext& context, std::size_t index) {
    const commands::ScenePart& part = context.state.scene->parts[index];
    const std::string item = "part/" + std::to_string(index);
    // One number of the part, as an edit with the name of its field.
    const auto set = [&](const char* key, double value, const std::string& name, bool goes_on) {
        context.emit(commands::EditDeclaration{
            {commands::SetDeclared{key_of(index, key), toml::toml_number(value)}}, name, goes_on});
    };
    for (const PartField& entry : part_fields()) {
        NumberField field = entry.field;
        field.name = item + "/" + field.name;
        double value = part.*entry.value;
        bool goes_on = false;
        if (number_row(context, field, edits_, value, goes_on)) set(entry.key, value, field.name, goes_on);
    }
    // The damping is the only value that a part may leave to the body.
    row_label(context.theme, "Damping", "Kelvin\xe2\x80\x93Voigt time of the part; otherwise that of the body.");
    bool own = part.damping_s.has_value();
    const bool before = own;
    ImGui::Checkbox("its own##part_damping", &own);
    context.items.mark(item + "/own_damping");
    // A part that gets a damping of its own begins with that of the body, so that nothing changes until it is edited.
    if (own && !before) set("damping_s", context.state.settings.damping_s, item + "/own_damping", false);
    if (!own && before)
        context.emit(
            commands::EditDeclaration{{commands::RemoveDeclared{key_of(index, "damping_s")}}, item + "/own_damping"});
    if (own && before) {
        double damping_s = *part.damping_s;
        bool goes_on = false;
        const NumberField field{"Damping time \xcf\x84",
                                item + "/damping",
                                commands::Dimension::time,
                                "ms",
                                "Kelvin\xe2\x80\x93Voigt time [s] of the part.",
                                commands::damping_limits,
                                0.01,
                                "Kelvin\xe2\x80\x93Voigt time"};
        if (number_row(context, field, edits_, damping_s, goes_on)) set("damping_s", damping_s, field.name, goes_on);
    }
    // Values of the part that a calibration may find, as a list of their ids.
    for (const auto& [id, label] : {std::pair{"youngs_modulus", "modulus"}, std::pair{"damping", "damping"}}) {
        std::vector<std::string> wanted = part.calibrated;
        const auto found = std::find(wanted.begin(), wanted.end(), id);
        bool sought = found != wanted.end();
        row_label(context.theme, std::string("Unknown ") + label);
        if (ImGui::Checkbox((std::string("found by a fit##") + id).c_str(), &sought)) {
            if (sought)
                wanted.emplace_back(id);
            else
                wanted.erase(found);
            context.emit(commands::EditDeclaration{
                {commands::SetDeclared{key_of(index, "calibrate"), toml::toml_list(wanted, toml::toml_text)}},
                item + "/fit_" + id});
        }
        context.items.mark(item + "/fit_" + id);
    }
}

}  // namespace myo::ui::panels
