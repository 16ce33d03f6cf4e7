#include "panels/probe_panel.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "panels/declared_rows.hpp"
#include "panels/marker_edits.hpp"
#include "toml/toml_text.hpp"

namespace myo::ui::panels {
namespace {

constexpr int list_lines = 8;  // of the list before it scrolls

/// Word in the list. Without recordings nothing is compared, so that all are called probes.
const char* kind_of(const commands::SceneMarker& marker, bool recorded) {
    return marker.probe || !recorded ? "probe" : "marker";
}

}  // namespace

void ProbePanel::draw(PanelContext& context) {
    const commands::Scene& scene = *context.state.scene;
    draw_placing(context);
    if (scene.markers.empty()) {
        muted_text(context.theme,
                   "Nothing is observed yet. A probe is a place on the body whose simulated motion is plotted.");
    } else {
        draw_list(context);
        draw_marker(context, scene.markers[static_cast<std::size_t>(context.state.marker)]);
    }
    // A limit for all markers: one that lies farther off is taken for a mistake by the reader.
    double standoff_m = scene.declared.max_standoff_m;
    bool goes_on = false;
    const NumberField field{
        "Stand-off up to",
        "probe/standoff",
        commands::Dimension::length,
        "mm",
        "Largest distance of a marker from the surface. A marker off the surface moves rigidly with "
        "the nearest point of it.",
        {0.0, 0.1},
        0.01};
    if (number_row(context, field, edits_, standoff_m, goes_on))
        context.emit(commands::EditDeclaration{
            {commands::SetDeclared{{"markers", "max_standoff_m"}, toml::toml_number(standoff_m)}},
            field.name,
            goes_on});
}

void ProbePanel::draw_placing(PanelContext& context) {
    const commands::Scene& scene = *context.state.scene;
    const bool placing = context.placing.sets(Placing::Kind::markers);
    ImGui::BeginDisabled(!context.state.body);
    if (toggle_button(context.theme, placing ? "End adding by clicking" : "Add by clicking", placing)) {
        // A second press ends the tool; a press during another tool takes its place.
        context.placing = {};
        if (!placing) context.placing.kind = Placing::Kind::markers;
    }
    ImGui::EndDisabled();
    context.items.mark("probe/place");
    tooltip(context.theme, context.state.body
                               ? "Click anywhere on the body to add one. Click one to select it, drag it to move it on "
                                 "the surface; Delete removes it, Escape ends."
                               : "Build the mesh first.");
    if (!placing) return;
    row_label(context.theme, "Name of the next", "Without a name: m1, m2, \xe2\x80\xa6");
    // The hint is the name that the next one gets if nothing is typed.
    ImGui::InputTextWithHint("##probe/next", free_marker_name(scene, "").c_str(), &context.placing.next_name);
    context.items.mark("probe/next");
    if (has_recordings(scene))
        muted_text(context.theme,
                   "What is added is a probe: no recording holds it, it is simulated and plotted only. Tick Recorded "
                   "where every recording holds it.");
}

void ProbePanel::draw_list(PanelContext& context) {
    const commands::Scene& scene = *context.state.scene;
    const bool recorded = has_recordings(scene);
    const auto count = static_cast<int>(scene.markers.size());
    const float line = ImGui::GetTextLineHeightWithSpacing();
    // As high as its entries, up to list_lines of them; the fraction of a line is the frame.
    ImGui::BeginChild("##probe/list", {0.0f, line * (static_cast<float>(std::min(count, list_lines)) + 0.6f)}, true);
    for (int m = 0; m < count; ++m) {
        const commands::SceneMarker& marker = scene.markers[static_cast<std::size_t>(m)];
        if (ImGui::Selectable((marker.name + "##probe").c_str(), m == context.state.marker))
            context.emit(commands::ChooseMarker{m});
        context.items.mark("probe/list/" + marker.name);
        const char* const kind = kind_of(marker, recorded);
        ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(kind).x);
        ImGui::TextColored(context.theme.muted, "%s", kind);
    }
    ImGui::EndChild();
}

void ProbePanel::draw_marker(PanelContext& context, const commands::SceneMarker& marker) {
    std::string name = marker.name;
    if (names_.row(context, "Name", "probe/name", "Heads its columns in results. Recordings keep their own label.",
                   name))
        context.emit(commands::EditDeclaration{{commands::RenameMarker{marker.name, name}}, "probe/name"});
    const NumberField field{"",  "", commands::Dimension::length, "mm", "Place on the body at rest [m].", {-10.0, 10.0},
                            0.05};
    vector_rows(context, {marker_path(marker), "probe/place/" + marker.name}, "Place", field, edits_, marker.rest_m);
    draw_recorded(context, marker);
    if (ImGui::Button("Remove", {-1.0f, 0.0f})) remove_marker(context, marker);
    context.items.mark("probe/remove");
    tooltip(context.theme, "Removes it from the experiment; recordings stay as they are.");
}

void ProbePanel::draw_recorded(PanelContext& context, const commands::SceneMarker& marker) {
    if (!has_recordings(*context.state.scene)) return;
    bool recorded = !marker.probe;
    row_label(context.theme, "Recorded", "Ticked: every recording holds it, and it is compared.");
    if (ImGui::Checkbox("##probe/recorded", &recorded)) {
        commands::SceneMarker changed = marker;
        changed.probe = !recorded;
        // A marker becomes a probe by moving to another table. A probe has no label, so that of the marker goes.
        context.emit(
            commands::EditDeclaration{{commands::RemoveDeclared{marker_path(marker)},
                                       commands::RemoveDeclared{{"markers", "labels", marker.name}},
                                       commands::SetDeclared{marker_path(changed), toml::toml_vector(marker.rest_m)}},
                                      "probe/recorded"});
    }
    context.items.mark("probe/recorded");
    if (marker.probe) return;
    std::string label = marker.label;
    if (!names_.row(context, "Label", "probe/label", "Name of the marker in the recordings.", label)) return;
    const toml::TomlPath path{"markers", "labels", marker.name};
    // The label of a marker is its name unless it is declared.
    const commands::DeclarationEdit edit = label.empty() || label == marker.name
                                               ? commands::DeclarationEdit(commands::RemoveDeclared{path})
                                               : commands::SetDeclared{path, toml::toml_text(label)};
    context.emit(commands::EditDeclaration{{edit}, "probe/label"});
}

}  // namespace myo::ui::panels
