#include "panels/file_browser.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "base/letter_case.hpp"
#include "panels/escape.hpp"
#include "panels/tables.hpp"
#include "panels/widgets.hpp"
#include "panels/wrapped_text.hpp"
#include "platform/fonts.hpp"

namespace myo::ui::panels {
namespace {

namespace fs = std::filesystem;

/// Extensions are compared in lower case: files may end in .C3D.
bool has_ending(const fs::path& file, const std::vector<std::string>& endings) {
    const std::string ending = lower_case(file.extension().string());
    return endings.empty() || std::find(endings.begin(), endings.end(), ending) != endings.end();
}

/// Enter outside text fields, which handle the key themselves.
bool enter_pressed() {
    return !ImGui::GetIO().WantTextInput &&
           (ImGui::IsKeyPressed(ImGuiKey_Enter, false) || ImGui::IsKeyPressed(ImGuiKey_KeyPadEnter, false));
}

/// Says next to the file name that the file exists. `again`: Enter was pressed once for this file.
void draw_replacement_warning(PanelContext& context, const fs::path& target, bool again) {
    const platform::Theme& theme = context.theme;
    // The two buttons of the foot keep their place at the right; the text is shortened to the room before them.
    const float room = ImGui::GetWindowContentRegionMax().x - ImGui::GetItemRectMax().x + ImGui::GetWindowPos().x -
                       240.0f * theme.scale;
    ImGui::SameLine();
    const std::string told = std::string(platform::icon::warning) + "  " +
                             (again ? "Enter again to replace it" : "Exists already: " + target.filename().string());
    ImGui::TextColored(theme.warning, "%s", elided(told, room).c_str());
    context.items.mark("browser/is_there");
    tooltip(theme, told);
}

}  // namespace

std::string with_ending(const std::string& name, const std::vector<std::string>& endings) {
    const bool has_one = endings.empty() ||
                         std::find(endings.begin(), endings.end(), fs::path(name).extension()) != endings.end();
    return name.empty() || has_one ? name : name + endings.front();
}

std::vector<FolderEntry> list_folder(const fs::path& folder, const std::vector<std::string>& endings) {
    std::vector<FolderEntry> entries;
    std::error_code problem;
    // Errors only shorten the list: a folder without permission must not end the program.
    for (fs::directory_iterator it(folder, problem), end; !problem && it != end; it.increment(problem)) {
        FolderEntry entry;
        entry.name = it->path().filename().string();
        // Hidden files are of no use here and would crowd the list.
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

/// Shows another folder. Selection and preview belong to the previous one.
void FileBrowser::go_to(const fs::path& folder) {
    folder_ = folder;
    typed_ = folder.string();
    entries_ = list_folder(folder, dialog_->endings);
    selected_.clear();
    previewed_.clear();
    preview_.clear();
}

/// Each dialog starts in its own folder, or in the working folder if there is none.
void FileBrowser::open(FileDialog dialog) {
    std::error_code ignored;
    dialog_ = std::move(dialog);
    name_ = dialog_->new_name;
    fs::path folder = fs::absolute(dialog_->start, ignored);
    // `start` may be a file or may no longer exist: use its folder, otherwise the working folder.
    if (!fs::is_directory(folder, ignored)) folder = folder.parent_path();
    if (dialog_->start.empty() || !fs::is_directory(folder, ignored)) folder = fs::current_path(ignored);
    go_to(folder);
    // A new experiment's folder holds no recordings: the files are where the last ones were.
    const bool empty = std::all_of(entries_.begin(), entries_.end(), [](const FolderEntry& e) { return e.folder; });
    if (!writes() && empty && fs::is_directory(last_, ignored)) go_to(last_);
    just_opened_ = true;
    typing_name_ = writes();
    replaced_.clear();
}

fs::path FileBrowser::target() const {
    return writes() ? folder_ / with_ending(name_, dialog_->endings) : folder_ / selected_;
}

void FileBrowser::choose(PanelContext& context, const fs::path& path) {
    // A copy, as the callback may open another dialog.
    const FileDialog dialog = *dialog_;
    if (!writes()) last_ = path.parent_path();
    dialog_.reset();
    ImGui::CloseCurrentPopup();
    dialog.chosen(context, path);
}

void FileBrowser::cancel(PanelContext& context) {
    const FileDialog dialog = *dialog_;
    dialog_.reset();
    ImGui::CloseCurrentPopup();
    if (dialog.given_up) dialog.given_up(context);
}

bool FileBrowser::draw_name(PanelContext& context, const fs::path& target, bool replaces) {
    const platform::Theme& theme = context.theme;
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Name");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(260.0f * theme.scale);
    // The keyboard goes to the name when the dialog opens, so that it can be typed at once.
    if (typing_name_) ImGui::SetKeyboardFocusHere();
    typing_name_ = false;
    const bool entered = ImGui::InputText("##name", &name_,
                                          ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    context.items.mark("browser/name");
    if (replaces) {
        // The first Enter only warns; replaced_ remembers for which file.
        draw_replacement_warning(context, target, target == replaced_);
    }
    ImGui::SameLine();
    if (!entered) return false;
    typing_name_ = true;
    // Replacing a file requires Enter twice: a single key press must not destroy a file.
    const bool may = !replaces || target == replaced_;
    replaced_ = target;
    return may;
}

/// The button is called Replace if the target exists. It enters a folder that cannot be chosen itself.
void FileBrowser::draw_foot(PanelContext& context) {
    const platform::Theme& theme = context.theme;
    const float width = 96.0f * theme.scale;
    std::error_code ignored;
    const fs::path asked = target();
    const bool replaces = writes() && !name_.empty() && fs::exists(asked, ignored);
    const bool entered = writes() ? draw_name(context, asked, replaces) : enter_pressed();
    ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - 2.0f * width - ImGui::GetStyle().ItemSpacing.x);
    const bool cancelled = ImGui::Button("Cancel", {width, 0.0f}) || escape_closes();
    context.items.mark("browser/cancel");
    ImGui::SameLine();
    // A folder can be chosen without a selection: then it is the shown one.
    const bool has_choice = writes() ? !name_.empty() && !fs::is_directory(asked, ignored)
                                     : !selected_.empty() || dialog_->folders;
    ImGui::BeginDisabled(!has_choice);
    const bool pressed = primary_button(theme, replaces ? "Replace" : dialog_->button, {width, 0.0f});
    context.items.mark("browser/open");
    ImGui::EndDisabled();
    if (cancelled) return cancel(context);
    if (!pressed && !(entered && has_choice)) return;
    const auto entry = std::find_if(entries_.begin(), entries_.end(),
                                    [&](const FolderEntry& e) { return e.name == selected_; });
    // A folder that cannot be chosen is entered.
    const bool plain_folder = !writes() && entry != entries_.end() && entry->folder &&
                              !(entry->experiment && dialog_->experiments) && !dialog_->folders;
    if (plain_folder)
        go_to(asked);
    else
        choose(context, selected_.empty() && !writes() ? folder_ : asked);
}

void FileBrowser::make_folder() {
    // What cannot be looked at, as a name that is too long, counts as not there: only the first error is told.
    std::error_code failed, ignored;
    const fs::path made = folder_ / new_folder_;
    const bool is_new = fs::create_directories(made, failed);
    // An existing folder of this name is opened, as that is what the user wants.
    if (is_new || fs::is_directory(made, ignored)) {
        go_to(made);
        typing_name_ = true;
        ImGui::CloseCurrentPopup();
    } else {
        problem_ = fs::exists(made, ignored) ? "A file of this name exists already."
                                             : "Cannot be created: " + failed.message();
        typing_folder_ = true;
    }
}

/// A new folder is shown at once, so that the file name can be typed next.
void FileBrowser::draw_new_folder(PanelContext& context) {
    const platform::Theme& theme = context.theme;
    // Every time the popup opens it is empty, with the keyboard in its field.
    if (ImGui::Button("New folder")) {
        new_folder_.clear();
        problem_.clear();
        typing_folder_ = true;
        ImGui::OpenPopup("new folder");
    }
    context.items.mark("browser/new_folder");
    ImGui::SameLine();
    if (!ImGui::BeginPopup("new folder")) return;
    if (typing_folder_) ImGui::SetKeyboardFocusHere();
    typing_folder_ = false;
    ImGui::SetNextItemWidth(240.0f * theme.scale);
    const bool entered = ImGui::InputTextWithHint("##new folder", "Name of the folder", &new_folder_,
                                                  ImGuiInputTextFlags_EnterReturnsTrue);
    context.items.mark("browser/new_folder/name");
    ImGui::SameLine();
    ImGui::BeginDisabled(new_folder_.empty());
    const bool pressed = ImGui::Button("Create") || (entered && !new_folder_.empty());
    context.items.mark("browser/new_folder/make");
    ImGui::EndDisabled();
    if (pressed) {
        make_folder();
    }
    // The popup stays open after a failure, so that another name can be typed.
    if (!problem_.empty()) ImGui::TextColored(theme.failure, "%s", problem_.c_str());
    if (escape_closes()) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

bool FileBrowser::begin(PanelContext& context) {
    const float s = context.theme.scale;
    // The part after ### identifies the popup, whatever title is shown.
    const std::string title = dialog_->title + "###file browser";
    // ImGui opens popups only within a frame, so open() just sets a flag.
    if (just_opened_) ImGui::OpenPopup(title.c_str());
    just_opened_ = false;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5f * display.x, 0.5f * display.y}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(860.0f * s, display.x - 40.0f), std::min(560.0f * s, display.y - 40.0f)});
    if (ImGui::BeginPopupModal(title.c_str(), nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove))
        return true;
    // If ImGui does not show the dialog any more, it counts as cancelled.
    const FileDialog dialog = *dialog_;
    dialog_.reset();
    if (dialog.given_up) dialog.given_up(context);
    return false;
}

void FileBrowser::draw_toolbar(PanelContext& context) {
    if (ImGui::Button(platform::icon::up)) go_to(folder_.parent_path());
    context.items.mark("browser/up");
    tooltip(context.theme, "Parent folder");
    ImGui::SameLine();
    const auto& kept = context.state.preferences.bookmarks;
    const bool marked = std::find(kept.begin(), kept.end(), folder_) != kept.end();
    if (ImGui::Button(marked ? platform::icon::star : platform::icon::empty_star))
        context.emit(commands::Bookmark{folder_, !marked});
    context.items.mark("browser/star");
    tooltip(context.theme,
            marked ? "Remove this folder from the list at the left" : "Add this folder to the list at the left");
    ImGui::SameLine();
    if (writes() || dialog_->folders) draw_new_folder(context);
}

std::optional<fs::path> FileBrowser::draw_path() {
    ImGui::SetNextItemWidth(-1.0f);
    std::optional<fs::path> chosen;
    if (ImGui::InputText("##path", &typed_, ImGuiInputTextFlags_EnterReturnsTrue)) {
        std::error_code ignored;
        const fs::path typed = typed_;
        // An experiment is chosen as a folder, a file by its path; any other folder is shown.
        const bool experiment = dialog_->experiments && fs::exists(typed / "experiment.toml", ignored);
        missing_.clear();
        if (experiment || (fs::is_regular_file(typed, ignored) && !writes()))
            chosen = typed;
        else if (fs::is_directory(typed, ignored))
            go_to(typed);
        else
            missing_ = typed_;
    }
    return chosen;
}

void FileBrowser::draw_columns(PanelContext& context) {
    const float s = context.theme.scale;
    // The lists leave room for the line of buttons below them.
    const float foot = ImGui::GetFrameHeightWithSpacing() + 4.0f * s;
    // The columns at the sides keep their widths; the list in the middle takes what is left.
    const float places = 170.0f * s, preview = 230.0f * s, gap = 2.0f * ImGui::GetStyle().ItemSpacing.x;
    const float middle = std::max(160.0f * s, ImGui::GetContentRegionAvail().x - places - preview - gap);
    ImGui::BeginChild("places", {places, -foot});
    draw_places(context);
    ImGui::EndChild();
    ImGui::SameLine();
    ImGui::BeginChild("entries", {middle, -foot});
    draw_entries(context);
    ImGui::EndChild();
    // A double click in the list may have closed the dialog.
    if (dialog_) {
        ImGui::SameLine();
        ImGui::BeginChild("preview", {0.0f, -foot});
        draw_preview(context);
        ImGui::EndChild();
    }
}

/// From top to bottom: the path with its buttons; places, entries and preview next to each other; the name and the
/// buttons. Each part may close the dialog, so dialog_ is checked before the next one.
void FileBrowser::draw(PanelContext& context) {
    if (!dialog_) return;
    if (!begin(context)) return;
    draw_toolbar(context);
    const std::optional<fs::path> typed_file = draw_path();
    context.items.mark("browser/path");
    if (!missing_.empty() && missing_ == typed_) {
        ImGui::TextColored(context.theme.failure, "There is no file or folder %s.", missing_.c_str());
        context.items.mark("browser/missing");
    }
    draw_columns(context);
    // Chosen at the end, as choosing closes the dialog while its parts are still being drawn.
    if (dialog_ && typed_file) choose(context, *typed_file);
    if (dialog_) draw_foot(context);
    if (!dialog_) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace myo::ui::panels
