#include "panels/body_panel.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include "commands/body_size.hpp"
#include "panels/file_dialogs.hpp"
#include "panels/widgets.hpp"
#include "platform/fonts.hpp"
#include "plot/number_text.hpp"

namespace myo::ui::panels {

namespace {

/// Name, size and contents of the open scene.
void draw_scene_facts(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    const commands::Scene& scene = *state.scene;
    heading(theme, scene.name);
    if (!scene.description.empty()) muted_text(theme, scene.description);
    ImGui::Spacing();
    // Millimetres suit soft robots of centimetres to decimetres.
    const Eigen::Vector3d size = 1e3 * commands::body_size(state);
    if (size.maxCoeff() > 0.0)
        text_row(theme, "Size",
                 plot::plain_label(size.x(), 4) + " \xc3\x97 " + plot::plain_label(size.y(), 4) + " \xc3\x97 " +
                     plot::plain_label(size.z(), 4) + " mm");
    if (scene.surface.triangles.cols() > 0)
        // Scenes from a volume mesh may have no surface of their own.
        text_row(theme, "Surface", with_separators(static_cast<double>(scene.surface.triangles.cols())) + " triangles");
    if (!scene.markers.empty()) text_row(theme, "Markers", std::to_string(scene.markers.size()));
    text_row(theme, "Trials", std::to_string(scene.trials.size()));
    if (!state.project.empty())
        text_row(theme, "Project",
                 state.project.filename().string() + (state.unsaved() ? ", unsaved changes" : ", saved"));
    for (const std::string& warning : scene.warnings) notice(theme, commands::LogLevel::warning, warning);
}

}  // namespace

void BodyPanel::draw_path(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    const float button = ImGui::GetFrameHeight() + 8.0f * theme.scale;
    ImGui::SetNextItemWidth(-(button + ImGui::GetStyle().ItemSpacing.x));
    if (ImGui::InputTextWithHint("##path", "Experiment, mesh or project", &path_,
                                 ImGuiInputTextFlags_EnterReturnsTrue) &&
        !path_.empty())
        context.emit(commands::Open{path_, std::nullopt});
    context.items.mark("body/path");
    // Paths are often longer than the field.
    if (!path_.empty()) tooltip(theme, path_);
    ImGui::SameLine();
    if (ImGui::Button(platform::icon::folder, {button, 0.0f}))
        context.window.file = open_dialog(path_.empty() && state.scene ? state.scene->path
                                                                       : std::filesystem::path(path_));
    context.items.mark("body/browse");
    tooltip(theme, "Browse (Ctrl+O)");
}

/// The field accepts any path and opens it with Enter; the button next to it opens the file browser. Below: name,
/// description, size and warnings of what is open, or an explanation of what can be opened.
void BodyPanel::draw(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    // The field also shows what was opened elsewhere: dropped, from the start page, or by the command line.
    if (scene_ != state.scene && state.scene)
        path_ = (state.project.empty() ? state.scene->path : state.project).string();
    scene_ = state.scene;
    draw_path(context);
    // What can be opened, and what is assumed about a mesh without an experiment.
    if (!state.scene) {
        muted_text(theme,
                   "A folder with an experiment.toml contains body, clamp, material and measured markers. For a closed "
                   "surface or a volume mesh alone, silicone is assumed, "
                   "held at the lower end of its longest axis.");
        return;
    }
    draw_scene_facts(context);
}

}  // namespace myo::ui::panels
