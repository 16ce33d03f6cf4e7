#include "panels/export_dialog.hpp"

#include <imgui.h>

#include "commands/field_store.hpp"
#include "panels/escape.hpp"
#include "panels/file_dialogs.hpp"
#include "panels/widgets.hpp"
#include "plot/number_text.hpp"

namespace myo::ui::panels {
namespace {

using commands::ShapeFormat;

/// Whether the shown trial has at least one simulated frame.
bool has_frames(const commands::WorkbenchState& state) {
    const commands::SimulatedTrial* const trial = state.simulated_trial();
    return trial && !trial->frames.empty();
}

}  // namespace

void ExportDialog::draw_formats(PanelContext& context) {
    struct Tab {
        ShapeFormat format;
        const char* label;
        const char* item;
        const char* tip;
    };
    for (const Tab& t : {Tab{ShapeFormat::vtu, "ParaView (VTU)", "export/vtu",
                             "The volume mesh, with the displacement and the shown quantity at the nodes."},
                         Tab{ShapeFormat::stl, "STL", "export/stl", "The surface, for printing and CAD."},
                         Tab{ShapeFormat::glb, "glTF (GLB)", "export/glb",
                             "The surface with its colours, for viewers, slides and web pages."}}) {
        if (t.format != ShapeFormat::vtu) ImGui::SameLine();
        if (tab(context.theme, t.label, what_.format == t.format)) what_.format = t.format;
        context.items.mark(t.item);
        tooltip(context.theme, t.tip);
    }
}

void ExportDialog::draw_options(PanelContext& context) {
    if (what_.format == ShapeFormat::vtu) {
        std::string id = what_.all_frames ? "all" : "shown";
        choice_row(context, "Frames", "export/frames", "The body at the shown time, or in every frame of the trial.",
                   {{"shown", "The shown time", ""}, {"all", "All frames, with a collection (PVD)", ""}}, id);
        what_.all_frames = id == "all";
    } else if (what_.format == ShapeFormat::stl) {
        std::string id = what_.metres_per_unit == 1.0 ? "m" : "mm";
        choice_row(context, "Unit", "export/unit", "An STL file does not name its unit; printers expect millimetres.",
                   {{"mm", "Millimetres", ""}, {"m", "Metres", ""}}, id);
        what_.metres_per_unit = id == "m" ? 1.0 : 1e-3;
    }
}

void ExportDialog::draw_content(PanelContext& context) const {
    const commands::WorkbenchState& state = context.state;
    const bool all = what_.format == ShapeFormat::vtu && what_.all_frames;
    std::string content = !has_frames(state) ? "the body at rest, as there is no run"
                          : all              ? std::to_string(state.simulated_trial()->frames.size()) + " frames of " +
                                      state.scene_trial()->name
                                : "the body at t = " + plot::value_label(state.time_s, 4) + " s";
    const std::optional<commands::FieldKind> field = commands::shown_field(state, context.backend);
    // STL has no values, and the force of a diagnosis is not exported.
    if (field && has_frames(state) && what_.format != ShapeFormat::stl && !commands::of_diagnosis(*field))
        content += ", with " + field->label;
    text_row(context.theme, "Content", content);
}

void ExportDialog::ask_for_file(PanelContext& context) const {
    commands::ShapeExport asked = what_;
    // The choice of frames stays in what_ for the next VTU file; other formats ignore it.
    asked.all_frames = what_.format == ShapeFormat::vtu && what_.all_frames;
    const std::string ending = asked.all_frames                   ? ".pvd"
                               : asked.format == ShapeFormat::vtu ? ".vtu"
                               : asked.format == ShapeFormat::stl ? ".stl"
                                                                  : ".glb";
    const commands::SceneTrial* const trial = context.state.scene_trial();
    context.window.file = body_dialog(asked, (trial ? trial->name : context.state.scene->name) + ending);
}

void ExportDialog::draw(PanelContext& context) {
    if (!open_ || !context.state.body) return;
    if (!begin_dialog(context.theme, "Export the body", 420.0f)) return;
    draw_formats(context);
    ImGui::Spacing();
    draw_options(context);
    draw_content(context);
    ImGui::Spacing();
    const float width = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
    // All frames need a run; a single shape can be the body at rest.
    const bool no_frames = what_.format == ShapeFormat::vtu && what_.all_frames && !has_frames(context.state);
    ImGui::BeginDisabled(no_frames);
    if (primary_button(context.theme, "Save as\xe2\x80\xa6", {width, 0.0f})) {
        ask_for_file(context);
        open_ = false;
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndDisabled();
    context.items.mark("export/where");
    if (no_frames) tooltip(context.theme, "Run the trial first.");
    ImGui::SameLine();
    if (ImGui::Button("Cancel", {width, 0.0f}) || escape_closes()) {
        open_ = false;
        ImGui::CloseCurrentPopup();
    }
    context.items.mark("export/cancel");
    ImGui::EndPopup();
}

}  // namespace myo::ui::panels
