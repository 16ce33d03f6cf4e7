#include "panels/file_browser.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include "panels/tables.hpp"
#include "panels/widgets.hpp"
#include "panels/wrapped_text.hpp"
#include "platform/fonts.hpp"

namespace myo {
namespace {

namespace fs = std::filesystem;

bool has_ending(const fs::path& file, const std::vector<std::string>& endings) {
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
    return endings.empty() || std::find(endings.begin(), endings.end(), ending) != endings.end();
}

std::string folder_name(const fs::path& folder) { return folder.filename().empty() ? folder.string() : folder.filename().string(); }

}  // namespace

std::vector<FolderEntry> list_folder(const fs::path& folder, const std::vector<std::string>& endings) {
    std::vector<FolderEntry> entries;
    std::error_code problem;
    for (fs::directory_iterator it(folder, problem), end; !problem && it != end; it.increment(problem)) {
        FolderEntry entry;
        entry.name = it->path().filename().string();
        if (entry.name.empty() || entry.name[0] == '.') continue;
        std::error_code ignored;
        entry.folder = it->is_directory(ignored);
        if (entry.folder) entry.experiment = fs::is_regular_file(it->path() / "experiment.toml", ignored);
        if (entry.folder || has_ending(it->path(), endings)) entries.push_back(entry);
    }
    std::sort(entries.begin(), entries.end(), [](const FolderEntry& a, const FolderEntry& b) {
        return a.folder != b.folder ? a.folder : a.name < b.name;
    });
    return entries;
}

void FileBrowser::go_to(const fs::path& folder) {
    folder_ = folder;
    typed_ = folder.string();
    entries_ = list_folder(folder, dialog_->endings);
    selected_.clear();
    previewed_.clear();
    preview_.clear();
}

void FileBrowser::open(FileDialog dialog) {
    std::error_code ignored;
    dialog_ = std::move(dialog);
    name_ = dialog_->new_name;
    fs::path folder = fs::absolute(dialog_->start, ignored);
    if (!fs::is_directory(folder, ignored)) folder = folder.parent_path();
    if (dialog_->start.empty() || !fs::is_directory(folder, ignored)) folder = fs::current_path(ignored);
    go_to(folder);
    just_opened_ = true;
}

void FileBrowser::choose(PanelContext& context, const fs::path& path) {
    const FileDialog dialog = *dialog_;
    dialog_.reset();
    ImGui::CloseCurrentPopup();
    dialog.chosen(context, path);
}

void FileBrowser::give_up(PanelContext& context) {
    const FileDialog dialog = *dialog_;
    dialog_.reset();
    ImGui::CloseCurrentPopup();
    if (dialog.given_up) dialog.given_up(context);
}

void FileBrowser::draw_places(PanelContext& context) {
    const WorkbenchState& state = context.state;
    const Theme& theme = context.theme;
    const auto place = [&](const char* icon, const std::string& label, const fs::path& folder, const std::string& item) {
        if (folder.empty()) return;
        ImGui::TextColored(theme.muted, "%s", icon);
        ImGui::SameLine(28.0f * theme.scale);
        ImGui::PushID(item.c_str());
        if (ImGui::Selectable(elided(label, ImGui::GetContentRegionAvail().x).c_str(), folder == folder_)) go_to(folder);
        ImGui::PopID();
        context.items.mark(item);
        tooltip(theme, folder.string());
    };
    const char* const home = std::getenv("HOME");
    std::error_code ignored;
    place(icon::home, "Home", home ? home : "", "browser/place/home");
    place(icon::closed_folder, "Working folder", fs::current_path(ignored), "browser/place/working");
    if (!state.examples.empty()) place(icon::cube, "Examples", state.examples.front().path.parent_path(), "browser/place/examples");
    for (std::size_t i = 0; i < state.preferences.bookmarks.size(); ++i) {
        const fs::path& folder = state.preferences.bookmarks[i];
        place(icon::star, folder_name(folder), folder, "browser/bookmark/" + std::to_string(i));
    }
}

void FileBrowser::draw_entries(PanelContext& context) {
    const Theme& theme = context.theme;
    if (entries_.empty()) muted_text(theme, "Nothing here that can be chosen.");
    std::optional<fs::path> enter, chosen;
    for (const FolderEntry& entry : entries_) {
        const bool experiment = entry.experiment && dialog_->experiments;
        const char* icon = experiment ? icon::cube : entry.folder ? icon::closed_folder : icon::file;
        ImGui::TextColored(experiment ? theme.accent : theme.muted, "%s", icon);
        ImGui::SameLine(28.0f * theme.scale);
        const char* const tag = "experiment";
        const float room = ImGui::GetContentRegionAvail().x - (experiment ? ImGui::CalcTextSize(tag).x + 16.0f * theme.scale : 0.0f);
        ImGui::PushID(entry.name.c_str());
        if (ImGui::Selectable(elided(entry.name, room).c_str(), selected_ == entry.name, ImGuiSelectableFlags_AllowDoubleClick)) {
            selected_ = entry.name;
            if (!entry.folder && !dialog_->new_name.empty()) name_ = entry.name;
            if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) (entry.folder && !experiment ? enter : chosen) = folder_ / entry.name;
        }
        ImGui::PopID();
        context.items.mark("browser/entry/" + entry.name);
        if (!experiment) continue;
        ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(tag).x - 4.0f * theme.scale);
        ImGui::TextColored(theme.muted, "%s", tag);
    }
    if (enter) go_to(*enter);
    else if (chosen && dialog_->new_name.empty()) choose(context, *chosen);
}

void FileBrowser::draw_preview(PanelContext& context) {
    const Theme& theme = context.theme;
    if (selected_.empty()) return muted_text(theme, "What is selected is described here.");
    const fs::path path = folder_ / selected_;
    if (path != previewed_) {
        previewed_ = path;
        preview_ = context.backend.preview(path);
    }
    ImGui::PushFont(theme.strong);
    wrapped_text(selected_);
    ImGui::PopFont();
    for (const ReportLine& line : preview_) {
        muted_text(theme, line.label);
        wrapped_text(line.value);
    }
}

void FileBrowser::draw_foot(PanelContext& context) {
    const Theme& theme = context.theme;
    const float width = 96.0f * theme.scale;
    const bool writes = !dialog_->new_name.empty();
    std::error_code ignored;
    const fs::path target = writes ? folder_ / name_ : folder_ / selected_;
    const bool replaces = writes && !name_.empty() && fs::exists(target, ignored);
    if (writes) {
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted("Name");
        ImGui::SameLine();
        ImGui::SetNextItemWidth(260.0f * theme.scale);
        ImGui::InputText("##name", &name_);
        context.items.mark("browser/name");
        if (replaces) {
            ImGui::SameLine();
            ImGui::TextColored(theme.warning, "%s  is there already", icon::warning);
        }
        ImGui::SameLine();
    }
    ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - 2.0f * width - ImGui::GetStyle().ItemSpacing.x);
    const bool cancelled = ImGui::Button("Cancel", {width, 0.0f}) || ImGui::IsKeyPressed(ImGuiKey_Escape, false);
    context.items.mark("browser/cancel");
    ImGui::SameLine();
    const bool has_choice = writes ? !name_.empty() && !fs::is_directory(target, ignored) : !selected_.empty() || dialog_->folders;
    ImGui::BeginDisabled(!has_choice);
    const bool pressed = primary_button(theme, replaces ? "Replace" : dialog_->button, {width, 0.0f});
    context.items.mark("browser/open");
    ImGui::EndDisabled();
    if (cancelled) return give_up(context);
    if (!pressed) return;
    const auto entry = std::find_if(entries_.begin(), entries_.end(), [&](const FolderEntry& e) { return e.name == selected_; });
    const bool plain_folder = !writes && entry != entries_.end() && entry->folder && !(entry->experiment && dialog_->experiments) && !dialog_->folders;
    if (plain_folder) go_to(target);
    else choose(context, selected_.empty() && !writes ? folder_ : target);
}

void FileBrowser::draw(PanelContext& context) {
    if (!dialog_) return;
    const float s = context.theme.scale;
    const std::string title = dialog_->title + "###file browser";
    if (just_opened_) ImGui::OpenPopup(title.c_str());
    just_opened_ = false;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5f * display.x, 0.5f * display.y}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(860.0f * s, display.x - 40.0f), std::min(560.0f * s, display.y - 40.0f)});
    if (!ImGui::BeginPopupModal(title.c_str(), nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove)) {
        const FileDialog dialog = *dialog_;
        dialog_.reset();
        if (dialog.given_up) dialog.given_up(context);
        return;
    }
    if (ImGui::Button(icon::up)) go_to(folder_.parent_path());
    context.items.mark("browser/up");
    tooltip(context.theme, "The folder above");
    ImGui::SameLine();
    const auto& kept = context.state.preferences.bookmarks;
    const bool marked = std::find(kept.begin(), kept.end(), folder_) != kept.end();
    if (ImGui::Button(marked ? icon::star : icon::empty_star)) context.emit(command::Bookmark{folder_, !marked});
    context.items.mark("browser/star");
    tooltip(context.theme, marked ? "Take this folder off the list at the left" : "Keep this folder in the list at the left");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1.0f);
    std::optional<fs::path> typed_file;
    if (ImGui::InputText("##path", &typed_, ImGuiInputTextFlags_EnterReturnsTrue)) {
        std::error_code ignored;
        if (fs::is_directory(typed_, ignored)) go_to(typed_);
        else if (fs::is_regular_file(typed_, ignored) && dialog_->new_name.empty()) typed_file = typed_;
    }
    context.items.mark("browser/path");
    const float foot = ImGui::GetFrameHeightWithSpacing() + 4.0f * s;
    const float places = 170.0f * s, preview = 230.0f * s, gap = 2.0f * ImGui::GetStyle().ItemSpacing.x;
    const float middle = std::max(160.0f * s, ImGui::GetContentRegionAvail().x - places - preview - gap);
    ImGui::BeginChild("places", {places, -foot});
    draw_places(context);
    ImGui::EndChild();
    ImGui::SameLine();
    ImGui::BeginChild("entries", {middle, -foot});
    draw_entries(context);
    ImGui::EndChild();
    if (dialog_) {
        ImGui::SameLine();
        ImGui::BeginChild("preview", {0.0f, -foot});
        draw_preview(context);
        ImGui::EndChild();
    }
    if (dialog_ && typed_file) choose(context, *typed_file);
    if (dialog_) draw_foot(context);
    if (!dialog_) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace myo
