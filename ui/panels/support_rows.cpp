#include "panels/support_rows.hpp"

#include <imgui.h>

#include "mesh/surface_mesh.hpp"
#include "panels/axis_ticks.hpp"
#include "panels/declared_list.hpp"
#include "panels/declared_rows.hpp"
#include "toml/toml_text.hpp"

namespace myo::ui::panels {
namespace {

/// Names of the held axes: "y, z".
std::string axes_words(const std::array<bool, 3>& held) {
    std::string words;
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (held[axis]) words += (words.empty() ? "" : ", ") + std::string(axis_names[axis]);
    return words;
}

/// Buttons that add a support: at the free end, or at a face that is clicked.
void draw_add(PanelContext& context) {
    const commands::Scene& scene = *context.state.scene;
    const toml::TomlPath array{"support"};
    const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2.0f;
    if (ImGui::Button("Add a support", {half, 0.0f})) {
        // At the free end a support changes something; at the clamp it would hold what is held already.
        const BodyEnd end = free_end(scene);
        const Box box = end_box(mesh::bounding_box(scene.surface.vertices), end.axis, end.upper);
        context.emit(commands::EditDeclaration{{commands::AppendDeclared{array, "box_m = " + box_text(box) + "\n"}},
                                               "support/more/add"});
        open_item(context, "support/more/" + std::to_string(scene.supports.size()));
    }
    context.items.mark("support/more/add");
    tooltip(context.theme, "A further place where the body is held, at first its free end, along all axes.");
    ImGui::SameLine();
    const bool picks = context.placing.sets_box(array);
    ImGui::BeginDisabled(!context.state.body);
    if (toggle_button(context.theme, "Add at a face##support", picks)) {
        context.placing = {};
        if (!picks) {
            context.placing.kind = Placing::Kind::box;
            // The array itself: the click appends a support with its box.
            context.placing.box = array;
            context.placing.adds = true;
            context.placing.item = "support/more";
            context.placing.what = "the face that is held";
        }
    }
    ImGui::EndDisabled();
    context.items.mark("support/more/pick");
    tooltip(context.theme,
            context.state.body ? "Click a face of the body: a thin box around it is held." : "Build the mesh first.");
}

}  // namespace

void draw_supports(PanelContext& context, NumberEdits& edits) {
    const commands::SceneSupports& supports = context.state.scene->supports;
    for (std::size_t i = 0; i < supports.size(); ++i) {
        const std::string item = "support/more/" + std::to_string(i);
        const toml::TomlPath path{"support", i};
        const std::string title = "Support " + std::to_string(i + 1) + ": holds " + axes_words(supports[i].held);
        const char* const
            tip = "Material in the box does not move along the held axes; the bars in the view show them.";
        if (item_heading(context, {item, title, tip, "Remove the support"}) == ItemPress::removed)
            context.emit(commands::EditDeclaration{{commands::RemoveDeclared{path}}, item + "/remove"});
        if (!is_open(context, item)) continue;
        // Keys of this support in the declaration.
        toml::TomlPath held = path;
        held.emplace_back("held");
        axis_ticks(context, "Held along",
                   "Axes along which the material in the box does not move. A roller along x holds y and z.",
                   supports[i].held, held, item);
        toml::TomlPath box = path;
        box.emplace_back("box_m");
        box_rows(context, {box, item + "/box"}, edits, supports[i].box_m);
        pick_box_button(context, {box, item + "/box"}, "the face that is held");
    }
    draw_add(context);
}

}  // namespace myo::ui::panels
