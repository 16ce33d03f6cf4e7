#pragma once

#include "panels/panel.hpp"

namespace myo::ui::panels {

/// Dialog that opens an experiment, a mesh or a project. `start`: a folder, or a file in it.
FileDialog open_dialog(const std::filesystem::path& start);
/// Dialog that makes an experiment of the open mesh, in a new folder.
FileDialog experiment_dialog(const std::filesystem::path& mesh);
/// Dialog that chooses a motion capture file to import.
FileDialog recording_dialog(const std::filesystem::path& start);
/// Dialog that saves the project under a new name. Requires an open scene.
FileDialog save_dialog(const commands::WorkbenchState& state);
/// Dialog for saving the 3D view. `name` is the proposed name; its extension determines whether one image, a folder of
/// numbered images or a video is written.
FileDialog picture_dialog(const PictureRequest& request, const std::string& name);
/// Dialog that chooses the closed surface of a part of the body.
FileDialog part_surface_dialog(const commands::Scene& scene,
                               std::function<void(PanelContext&, const std::filesystem::path&)> chosen);
/// Dialog that saves a part of the window as a PNG image. `part` in pixels of the window.
FileDialog part_dialog(std::string title, const std::string& name, const platform::Rectangle& part);
/// Dialog that writes a text, such as a table or a drawing, to a file. Success and failure are logged.
///
/// @param title  for example "Save the markers' errors"
/// @param name  proposed file name without extension
/// @param table  text as it is now
/// @param ending  extension of the file
FileDialog table_dialog(std::string title, const std::string& name, std::string table,
                        const std::string& ending = ".csv");

/// Dialog that writes the body for other programs. `name` is the proposed name with the extension of the format.
FileDialog body_dialog(const commands::ShapeExport& what, const std::string& name);
/// Dialog that copies the experiment, with its edits, into a new folder.
FileDialog experiment_copy_dialog(const std::filesystem::path& experiment);
/// Dialog that saves the project under a new name, with body and recordings inside. Requires an open scene.
FileDialog self_contained_dialog(const commands::WorkbenchState& state);
/// Dialog that finds the experiment or mesh of a project.
FileDialog locate_dialog(const commands::MissingSource& missing);

}  // namespace myo::ui::panels
