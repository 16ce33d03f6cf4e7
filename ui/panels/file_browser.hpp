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

/// Folders first, then files that can be opened, each in alphabetical order; hidden ones are left out.
std::vector<FolderEntry> list_folder(const std::filesystem::path& folder);

/// A dialog to choose an experiment folder or a mesh file. There is none in the libraries used.
class FileBrowser {
public:
    /// Opens at this folder, or at the folder of this file; at the working folder when it does not exist.
    void open(const std::filesystem::path& start);

    /// The choice, once.
    std::optional<std::filesystem::path> draw(PanelContext& context);

private:
    void go_to(const std::filesystem::path& folder);

    bool open_requested_ = false;
    std::filesystem::path folder_;
    std::string typed_;
    std::vector<FolderEntry> entries_;
    std::string selected_;
};

}  // namespace myo
