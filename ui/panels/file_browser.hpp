#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "panels/panel.hpp"

namespace myo {

/// One line of a folder's list.
struct FolderEntry {
    std::string name;
    bool folder = false;
    bool experiment = false;   // a folder that holds experiment.toml
};

/// Folders first, then files with one of these endings (any case; none given: all), each in alphabetical order; hidden ones are left out.
std::vector<FolderEntry> list_folder(const std::filesystem::path& folder, const std::vector<std::string>& endings);

/// A dialog to choose a file or a folder. There is none in the libraries used.
class FileBrowser {
public:
    void open(FileDialog dialog);
    bool is_open() const { return dialog_.has_value(); }
    void draw(PanelContext& context);

private:
    void go_to(const std::filesystem::path& folder);
    void draw_places(PanelContext& context);
    void draw_entries(PanelContext& context);
    void draw_preview(PanelContext& context);
    void draw_foot(PanelContext& context);
    void choose(PanelContext& context, const std::filesystem::path& path);
    void give_up(PanelContext& context);

    std::optional<FileDialog> dialog_;
    bool just_opened_ = false;
    std::filesystem::path folder_;
    std::string typed_;
    std::string name_;                         // of the file to be written
    std::vector<FolderEntry> entries_;
    std::string selected_;
    std::filesystem::path previewed_;
    std::vector<ReportLine> preview_;
};

}  // namespace myo
