#include "panels/part_panel.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <utility>

#include "mesh/surface_mesh.hpp"
#include "panels/declared_list.hpp"
#include "panels/declared_rows.hpp"
#include "toml/toml_text.hpp"

namespace myo::ui::panels {
namespace {

/// A name that no part has: "part", "part_2".
std::string free_part_name(const commands::Scene& scene) {
    std::string name = "part";
    const auto taken = [&](const commands::ScenePart& part) { return part.name == name; };
    for (int k = 2; std::any_of(scene.parts.begin(), scene.parts.end(), taken); ++k) name = "part_" + std::to_string(k);
    return name;
}

/// The half of the body that is farther from its support, with a margin around the body.
Box far_half(const commands::Scene& scene) {
    const Box body = mesh::bounding_box(scene.surface.vertices);
    const BodyEnd end = free_end(scene);
    Box half = end_box(body, end.axis, end.upper);
    const double middle = 0.5 * (body.lowest(end.axis) + body.highest(end.axis));
    (end.upper ? half.lowest : half.highest)(end.axis) = middle;
    return half;
}

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
    if (ImGui::Button("Add a part", {-1.0f, 0.0f})) {
        // The modulus is that of the body, so that nothing changes until it is edited.
        const std::string body = "name = " + toml::toml_text(free_part_name(scene)) +
                                 "\nbox_m = " + box_text(far_half(scene)) + "\nyoungs_modulus_Pa = " +
                                 toml::toml_number(context.state.settings.youngs_modulus_Pa) + "\n";
        context.emit(commands::EditDeclaration{{commands::AppendDeclared{{"part"}, body}}, "part/add"});
        open_item(context, "part/" + std::to_string(scene.parts.size()));
    }
    context.items.mark("part/add");
    tooltip(context.theme,
            "A box of the body with a material of its own, at first the half away from the support with the body's "
            "modulus. Where parts overlap, the later one counts.");
}

void PartPanel::draw_part(PanelContext& context, std::size_t index) {
    const commands::ScenePart& part = context.state.scene->parts[index];
    const std::string item = "part/" + std::to_string(index);
    if (item_heading(context, {item, part.name, "A part with a material of its own.", "Remove the part"}) ==
        ItemPress::removed)
        context.emit(commands::EditDeclaration{{commands::RemoveDeclared{{"part", index}}}, item + "/remove"});
    if (!is_open(context, item)) return;
    draw_name(context, index);
    // A place that is given by a file or by numbers of cells is shown, not edited.
    if (part.box_m)
        box_rows(context, {key_of(index, "box_m"), item + "/box"}, edits_, *part.box_m);
    else
        text_row(context.theme, "Place", part.place);
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
