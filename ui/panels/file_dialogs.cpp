#include "panels/file_dialogs.hpp"

namespace myo {

FileDialog open_dialog(const std::filesystem::path& start) {
    FileDialog dialog;
    dialog.title = "Open an experiment folder, a mesh or a project";
    dialog.button = "Open";
    dialog.endings = {".stl", ".obj", ".ply", ".vtp", ".vtu", ".vtk", ".msh", ".node", ".toml", project_ending};
    dialog.experiments = true;
    dialog.start = start;
    dialog.chosen = [](PanelContext& context, const std::filesystem::path& path) { context.emit(command::Open{path, std::nullopt}); };
    return dialog;
}

FileDialog save_dialog(const WorkbenchState& state) {
    FileDialog dialog;
    dialog.title = "Save the project";
    dialog.button = "Save";
    dialog.endings = {project_ending};
    dialog.start = state.project.empty() ? std::filesystem::path() : state.project;
    dialog.new_name = state.project.empty() ? state.scene->path.stem().string() + project_ending : state.project.filename().string();
    dialog.chosen = [](PanelContext& context, const std::filesystem::path& path) { context.emit(command::SaveAs{path}); };
    dialog.given_up = [](PanelContext& context) { context.emit(command::AskWhereToSave{false}); };
    return dialog;
}

FileDialog picture_dialog() {
    FileDialog dialog;
    dialog.title = "Save the 3D view as a picture";
    dialog.button = "Save";
    dialog.endings = {".png"};
    dialog.new_name = "picture.png";
    dialog.chosen = [](PanelContext& context, const std::filesystem::path& path) { context.window.picture = path; };
    return dialog;
}

}  // namespace myo
