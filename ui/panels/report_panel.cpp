#include "panels/report_panel.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <filesystem>

#include "panels/widgets.hpp"
#include "platform/fonts.hpp"

namespace myo::ui::panels {
namespace {

/// Proposed folder: next to the project, otherwise below the working folder. Results must not be mixed with
/// measurements.
std::string proposed_folder(const commands::WorkbenchState& state) {
    std::error_code ignored;
    const std::filesystem::path home = state.project.empty() ? std::filesystem::current_path(ignored) / "out"
                                                             : state.project.parent_path();
    const std::filesystem::path& named = state.project.empty() ? state.scene->path : state.project;
    const std::string name = named.stem().empty() ? named.parent_path().filename().string() : named.stem().string();
    return (home / (name + " report")).string();
}

/// The files of the report, with the checks of what they contain.
void draw_file_list(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    muted_text(theme, "Files to be written");
    const auto row = [&](bool there, const std::string& file, const std::string& what,
                         // Each row names a file that will be written, with the checks of what it contains.
                         const commands::CheckRows& checks = {}) {
        // A file with doubtful contents has the colour of its checks, and says so.
        const commands::CheckState worst = commands::worst_state(checks);
        const std::string doubts = worst == commands::CheckState::green ? ""
                                                                        : ", checks: " + commands::doubt_text(checks);
        notice(theme, there ? commands::log_level(worst) : commands::LogLevel::information,
               file + ": " + what + doubts);
    };
    row(true, "<trial>.csv", "simulated markers of the shown run", state.run->checks);
    row(true, "picture.png", "the 3D view as it is now");
    row(state.found && state.found->page, "fit.html",
        state.found ? "the last calibration or optimisation" : "comes with a calibration or an optimisation",
        state.found ? state.found->run.checks : commands::CheckRows{});
    row(state.diagnosis && state.diagnosis->page, "diagnosis.html",
        state.diagnosis ? "the last diagnosis" : "comes with a diagnosis",
        state.diagnosis ? state.diagnosis->checks : commands::CheckRows{});
}

}  // namespace

void ReportPanel::draw_folder(PanelContext& context) {
    const platform::Theme& theme = context.theme;
    muted_text(theme, "Folder");
    const float button = ImGui::GetFrameHeight() + 8.0f * theme.scale;
    ImGui::SetNextItemWidth(-(button + ImGui::GetStyle().ItemSpacing.x));
    ImGui::InputText("##folder", &folder_);
    context.items.mark("report/folder");
    ImGui::SameLine();
    if (ImGui::Button(platform::icon::folder, {button, 0.0f})) {
        FileDialog dialog;
        dialog.title = "Folder for the report";
        dialog.button = "Choose";
        dialog.folders = true;
        dialog.start = std::filesystem::path(folder_).parent_path();
        // Panels live as long as the window, and so longer than its dialogs.
        dialog.chosen = [this](PanelContext&, const std::filesystem::path& path) { folder_ = path.string(); };
        context.window.file = std::move(dialog);
    }
    context.items.mark("report/browse");
}

/// Lists what will be written and what each part requires, so that a missing page is no surprise.
void ReportPanel::draw(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    if (!state.scene || !state.run)
        return muted_text(theme,
                          "Run, calibrate or diagnose first; then a report with tables and a picture can be written.");
    // An edited folder is kept until another scene is opened.
    if (scene_ != state.scene) folder_ = proposed_folder(state);
    scene_ = state.scene;
    draw_folder(context);
    ImGui::Spacing();
    draw_file_list(context);
    ImGui::Spacing();
    ImGui::BeginDisabled(folder_.empty());
    if (primary_button(theme, "Write the report", {-1.0f, 0.0f})) {
        // The pages are written by the workbench, the image by the window, which owns the view.
        context.emit(commands::WriteReport{folder_, 1});
        context.window.picture = PictureRequest{std::filesystem::path(folder_) / "picture.png"};
    }
    context.items.mark("report/write");
    ImGui::EndDisabled();
}

}  // namespace myo::ui::panels
