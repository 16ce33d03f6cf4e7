#include "panels/file_browser.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>

#include "panels/widgets.hpp"
#include "platform/fonts.hpp"

namespace myo {
namespace {

bool can_be_opened(const std::filesystem::path& file) {
    static const std::vector<std::string> endings{".stl", ".obj", ".ply", ".vtp", ".vtu", ".vtk", ".msh", ".node", ".toml"};
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
    return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

}  // namespace

std::vector<FolderEntry> list_folder(const std::filesystem::path& folder) {
    std::vector<FolderEntry> entries;
    std::error_code problem;
    for (std::filesystem::directory_iterator it(folder, problem), end; !problem && it != end; it.increment(problem)) {
        FolderEntry entry;
        entry.name = it->path().filename().string();
        if (entry.name.empty() || entry.name[0] == '.') continue;
        std::error_code ignored;
        entry.folder = it->is_directory(ignored);
        if (entry.folder) entry.experiment = std::filesystem::is_regular_file(it->path() / "experiment.toml", ignored);
        if (entry.folder || can_be_opened(it->path())) entries.push_back(entry);
    }
    std::sort(entries.begin(), entries.end(), [](const FolderEntry& a, const FolderEntry& b) {
        return a.folder != b.folder ? a.folder : a.name < b.name;
    });
    return entries;
}

void FileBrowser::go_to(const std::filesystem::path& folder) {
    folder_ = folder;
    typed_ = folder.string();
    entries_ = list_folder(folder);
    selected_.clear();
}

void FileBrowser::open(const std::filesystem::path& start) {
    std::error_code ignored;
    std::filesystem::path folder = std::filesystem::absolute(start, ignored);
    if (!std::filesystem::is_directory(folder, ignored)) folder = folder.parent_path();
    if (start.empty() || !std::filesystem::is_directory(folder, ignored)) folder = std::filesystem::current_path(ignored);
    go_to(folder);
    open_requested_ = true;
}

std::optional<std::filesystem::path> FileBrowser::draw(PanelContext& context) {
    const Theme& theme = context.theme;
    const float s = theme.scale;
    if (open_requested_) ImGui::OpenPopup("Open an experiment folder or a mesh");
    open_requested_ = false;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5f * display.x, 0.5f * display.y}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(640.0f * s, display.x - 40.0f), std::min(520.0f * s, display.y - 40.0f)});
    if (!ImGui::BeginPopupModal("Open an experiment folder or a mesh", nullptr, ImGuiWindowFlags_NoResize)) return std::nullopt;
    std::optional<std::filesystem::path> chosen;
    if (ImGui::Button(icon::up)) go_to(folder_.parent_path());
    context.items.mark("browser/up");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1.0f);
    if (ImGui::InputText("##path", &typed_, ImGuiInputTextFlags_EnterReturnsTrue)) {
        std::error_code ignored;
        if (std::filesystem::is_directory(typed_, ignored)) go_to(typed_);
        else if (std::filesystem::is_regular_file(typed_, ignored)) chosen = typed_;
    }
    context.items.mark("browser/path");
    std::optional<std::filesystem::path> enter;
    ImGui::BeginChild("entries", {0.0f, -ImGui::GetFrameHeightWithSpacing() - 4.0f * s});
    if (entries_.empty()) muted_text(theme, "Nothing here that can be opened.");
    for (const FolderEntry& entry : entries_) {
        const char* icon = entry.experiment ? icon::cube : entry.folder ? icon::closed_folder : icon::file;
        ImGui::TextColored(entry.experiment ? theme.accent : theme.muted, "%s", icon);
        ImGui::SameLine(32.0f * s);
        if (ImGui::Selectable(entry.name.c_str(), selected_ == entry.name, ImGuiSelectableFlags_AllowDoubleClick)) {
            selected_ = entry.name;
            if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
                (entry.folder && !entry.experiment ? enter : chosen) = folder_ / entry.name;
            }
        }
        context.items.mark("browser/entry/" + entry.name);
        if (entry.experiment) {
            const char* tag = "experiment";
            ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(tag).x - 4.0f * s);
            ImGui::TextColored(theme.muted, "%s", tag);
        }
    }
    ImGui::EndChild();
    if (enter) go_to(*enter);
    const float width = 96.0f * s;
    ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - 2.0f * width - ImGui::GetStyle().ItemSpacing.x);
    const bool cancelled = ImGui::Button("Cancel", {width, 0.0f}) || ImGui::IsKeyPressed(ImGuiKey_Escape, false);
    context.items.mark("browser/cancel");
    ImGui::SameLine();
    ImGui::BeginDisabled(selected_.empty());
    if (primary_button(theme, "Open", {width, 0.0f})) chosen = folder_ / selected_;
    context.items.mark("browser/open");
    ImGui::EndDisabled();
    if (chosen || cancelled) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return chosen;
}

}  // namespace myo
