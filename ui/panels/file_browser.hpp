#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "panels/panel.hpp"

namespace myo::ui::panels {

/// An entry in the list of a folder.
struct FolderEntry {
    std::string name;
    bool folder = false;
    bool experiment = false;  // a folder that contains experiment.toml
};

/// Lists a folder: folders first, then files, each in alphabetical order. Hidden entries are left out. Empty if the
/// folder cannot be read.
///
/// @param endings  extensions of the files to list, in lower case; empty: all files
std::vector<FolderEntry> list_folder(const std::filesystem::path& folder, const std::vector<std::string>& endings);

/// Appends the first of the endings to a name that has none of them. Returns an empty name unchanged.
std::string with_ending(const std::string& name, const std::vector<std::string>& endings);

/// Modal dialog to choose a file or a folder; the libraries in use do not provide one. It serves all file dialogs of
/// the window, one at a time.
///
/// What can be chosen follows from FileDialog: with `new_name` a file to write, which need not exist; with `folders`
/// any folder; with `experiments` folders with an experiment.toml; otherwise a file with one of the extensions. The
/// result is passed to the dialog's callbacks, which emit commands.
class FileBrowser {
public:
    /// Opens the dialog in the next frame.
    void open(FileDialog dialog);
    /// Whether the dialog is open.
    bool is_open() const { return dialog_.has_value(); }
    /// Draws the dialog while it is open. Its callbacks run within this call.
    void draw(PanelContext& context);

private:
    /// Whether a file name is entered; otherwise an existing file is chosen.
    bool writes() const { return !dialog_->new_name.empty(); }
    /// Path that the button would choose now.
    std::filesystem::path target() const;
    /// Shows a folder and clears the selection.
    void go_to(const std::filesystem::path& folder);
    /// List of fixed places and bookmarks.
    void draw_places(PanelContext& context);
    /// Entries of the shown folder.
    void draw_entries(PanelContext& context);
    /// Facts about the selected entry, from the backend.
    void draw_preview(PanelContext& context);
    /// Draws the field for the file name. Returns true if the user confirmed it with Enter.
    ///
    /// @param replaces  the target exists
    bool draw_name(PanelContext& context, const std::filesystem::path& target, bool replaces);
    /// File name, Cancel, and the button that chooses.
    void draw_foot(PanelContext& context);
    /// Button and popup that create a folder.
    void draw_new_folder(PanelContext& context);
    /// Creates the folder of the typed name and shows it.
    void make_folder();
    /// Opens and begins the popup. Returns false if it is not shown; if it was closed, that counts as cancelled.
    bool begin(PanelContext& context);
    /// Parent folder, bookmark and new folder.
    void draw_toolbar(PanelContext& context);
    /// Field for a path. Returns the file that was typed; a typed folder is shown.
    std::optional<std::filesystem::path> draw_path();
    /// Places, entries and preview, side by side.
    void draw_columns(PanelContext& context);
    /// Closes the dialog and calls the callback.
    void choose(PanelContext& context, const std::filesystem::path& path);
    /// Closes the dialog and reports that the user cancelled.
    void cancel(PanelContext& context);

    std::optional<FileDialog> dialog_;           // empty: closed
    bool just_opened_ = false;                   // the popup has to be opened in the next draw()
    std::filesystem::path folder_;               // shown folder
    std::filesystem::path last_;                 // folder of the file that was chosen last; empty: none yet
    std::string typed_;                          // text in the path field
    std::string missing_;                        // typed path that does not exist; empty: none
    std::string name_;                           // of the file to be written; the extension may be missing
    bool typing_name_ = false;                   // the name field gets the keyboard focus in the next frame
    std::filesystem::path replaced_;             // existing file for which Enter was pressed once
    std::string new_folder_;                     // text in the field for a new folder
    bool typing_folder_ = false;                 // that field gets the keyboard focus in the next frame
    std::string problem_;                        // why the new folder could not be created
    std::vector<FolderEntry> entries_;           // of the shown folder
    std::filesystem::path listed_;               // folder whose names have their letters loaded
    std::string selected_;                       // name of the selected entry; empty: none
    std::filesystem::path previewed_;            // path that preview_ describes
    std::vector<commands::ReportLine> preview_;  // facts about the selected entry
};

}  // namespace myo::ui::panels
