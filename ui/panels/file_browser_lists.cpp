#include <imgui.h>

#include <cstdlib>

#include "panels/file_browser.hpp"
#include "panels/tables.hpp"
#include "panels/widgets.hpp"
#include "panels/wrapped_text.hpp"
#include "platform/fonts.hpp"

namespace myo::ui::panels {
namespace {

namespace fs = std::filesystem;

constexpr const char* experiment_tag = "experiment";

/// The root folder has no file name.
std::string folder_name(const fs::path& folder) {
    return folder.filename().empty() ? folder.string() : folder.filename().string();
}

/// Icon of an entry: a cube in the accent colour for what can be opened as an experiment.
void draw_entry_icon(const platform::Theme& theme, bool experiment, bool folder) {
    const char* icon = experiment ? platform::icon::cube
                       : folder   ? platform::icon::closed_folder
                                  : platform::icon::file;
    ImGui::TextColored(experiment ? theme.accent : theme.muted, "%s", icon);
}

/// Experiment folders are marked on the right, as they are opened as a whole.
void draw_experiment_tag(const platform::Theme& theme) {
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(experiment_tag).x - 4.0f * theme.scale);
    ImGui::TextColored(theme.muted, "%s", experiment_tag);
}

}  // namespace

/// Bookmarks and fixed places on the left.
void FileBrowser::draw_places(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    // One entry; a place without a folder has none.
    const auto place = [&](const char* icon, const std::string& label, const fs::path& folder,
                           const std::string& item) {
        if (folder.empty()) return;
        ImGui::TextColored(theme.muted, "%s", icon);
        ImGui::SameLine(28.0f * theme.scale);
        ImGui::PushID(item.c_str());
        if (ImGui::Selectable(elided(label, ImGui::GetContentRegionAvail().x).c_str(), folder == folder_))
            go_to(folder);
        ImGui::PopID();
        context.items.mark(item);
        tooltip(theme, folder.string());
    };
    const char* const home = std::getenv("HOME");
    std::error_code ignored;
    // Without HOME the entry is left out.
    place(platform::icon::home, "Home", home ? home : "", "browser/place/home");
    place(platform::icon::closed_folder, "Working folder", fs::current_path(ignored), "browser/place/working");
    if (!state.examples.empty())
        place(platform::icon::cube, "Examples", state.examples.front().path.parent_path(), "browser/place/examples");
    for (std::size_t i = 0; i < state.preferences.bookmarks.size(); ++i) {
        const fs::path& folder = state.preferences.bookmarks[i];
        place(platform::icon::star, folder_name(folder), folder, "browser/bookmark/" + std::to_string(i));
    }
}

/// A double click enters a folder, but chooses an experiment folder.
void FileBrowser::draw_entries(PanelContext& context) {
    const platform::Theme& theme = context.theme;
    if (entries_.empty()) muted_text(theme, "No matching files here.");
    // A folder that was just entered has new names.
    if (listed_ != folder_)
        for (const FolderEntry& entry : entries_) context.window.letters += entry.name;
    listed_ = folder_;
    std::optional<fs::path> enter, chosen;
    for (const FolderEntry& entry : entries_) {
        const bool experiment = entry.experiment && dialog_->experiments;
        draw_entry_icon(theme, experiment, entry.folder);
        ImGui::SameLine(28.0f * theme.scale);
        const float room = ImGui::GetContentRegionAvail().x -
                           (experiment ? ImGui::CalcTextSize(experiment_tag).x + 16.0f * theme.scale : 0.0f);
        ImGui::PushID(entry.name.c_str());
        if (ImGui::Selectable(elided(entry.name, room).c_str(), selected_ == entry.name,
                              ImGuiSelectableFlags_AllowDoubleClick)) {
            selected_ = entry.name;
            // Clicking an existing file proposes to replace it.
            if (!entry.folder && writes()) name_ = entry.name;
            if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
                (entry.folder && !experiment ? enter : chosen) = folder_ / entry.name;
        }
        ImGui::PopID();
        context.items.mark("browser/entry/" + entry.name);
        if (experiment) draw_experiment_tag(theme);
    }
    // After the loop: go_to() replaces the list that the loop reads.
    if (enter)
        go_to(*enter);
    else if (chosen && !writes())
        choose(context, *chosen);
}

/// The facts come from the backend, which knows the file formats.
void FileBrowser::draw_preview(PanelContext& context) {
    const platform::Theme& theme = context.theme;
    if (selected_.empty()) return muted_text(theme, "Select a file to see its description.");
    const fs::path path = folder_ / selected_;
    // Reading the file takes time, so the preview is computed once per selection.
    if (path != previewed_) {
        previewed_ = path;
        preview_ = context.backend.preview(path);
    }
    ImGui::PushFont(theme.strong);
    wrapped_text(selected_);
    ImGui::PopFont();
    for (const commands::ReportLine& line : preview_) {
        muted_text(theme, line.label);
        wrapped_text(line.value);
    }
}

}  // namespace myo::ui::panels
