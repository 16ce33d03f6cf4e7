#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "panels/panel.hpp"

namespace myo::ui::panels {

/// One line of a folder's list.
struct FolderEntry {
    std::string name;
    bool folder = false;
    bool experiment = false;  // a folder that holds experiment.toml
};

/// Folders first, then files with one of these endings (any case; none given: all), each in alphabetical order; hidden
/// ones are left out.
std::vector<FolderEntry> list_folder(const std::filesystem::path& folder, const std::vector<std::string>& endings);

/// The name with the first of the endings, unless it has one of them; no endings: the name itself.
std::string with_ending(const std::string& name, const std::vector<std::string>& endings);

/// A dialog to choose a file or a folder. There is none in the libraries used.
class FileBrowser {
public:
    void open(FileDialog dialog);
    bool is_open() const { return dialog_.has_value(); }
    void draw(PanelContext& context);

private:
    /// Else an existing file is chosen.
    bool writes() const { return !dialog_->new_name.empty(); }
    /// What the button at the foot would choose now.
    std::filesystem::path target() const;
    void go_to(const std::filesystem::path& folder);
    void draw_places(PanelContext& context);
    void draw_entries(PanelContext& context);
    void draw_preview(PanelContext& context);
    /// True when the file is to be written.
    bool draw_name(PanelContext& context, const std::filesystem::path& target, bool replaces);
    void draw_foot(PanelContext& context);
    void draw_new_folder(PanelContext& context);
    void choose(PanelContext& context, const std::filesystem::path& path);
    void give_up(PanelContext& context);

    std::optional<FileDialog> dialog_;
    bool just_opened_ = false;
    std::filesystem::path folder_;
    std::string typed_;
    std::string name_;                // of the file to be written; its ending may be left out
    bool typing_name_ = false;        // its field gets the keyboard in the next frame
    std::filesystem::path replaced_;  // file over which Enter was pressed once
    std::string new_folder_;          // name that is being typed
    bool typing_folder_ = false;      // likewise
    std::string problem_;             // with it
    std::vector<FolderEntry> entries_;
    std::string selected_;
    std::filesystem::path previewed_;
    std::vector<commands::ReportLine> preview_;
};

}  // namespace myo::ui::panels
