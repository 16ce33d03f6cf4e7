#pragma once

#include "panels/panel.hpp"

namespace myo::ui::panels {

/// Opens an experiment, a mesh or a project; begins at a place.
FileDialog open_dialog(const std::filesystem::path& start);
/// Chooses a file of motion capture; begins at a place.
FileDialog recording_dialog(const std::filesystem::path& start);
/// Saves the project under a name.
FileDialog save_dialog(const commands::WorkbenchState& state);
/// Saves the 3D view: a picture, a new folder of numbered ones, or a film, as the proposed name says.
FileDialog picture_dialog(const PictureRequest& request, const std::string& name);
/// Saves a part of the window as it is seen.
FileDialog part_dialog(std::string title, const std::string& name, const platform::Rectangle& part);
/// Writes a text, as a table or a drawing.
/// @param title  "Save the markers' errors"
/// @param name   proposed, without ending
/// @param table  text as it is now
/// @param ending of the file
FileDialog table_dialog(std::string title, const std::string& name, std::string table,
                        const std::string& ending = ".csv");

}  // namespace myo::ui::panels
