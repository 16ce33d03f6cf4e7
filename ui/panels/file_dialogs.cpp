#include "panels/file_dialogs.hpp"

#include <utility>

#include "base/files.hpp"
#include "measurement/trace_file.hpp"

namespace myo::ui::panels {

FileDialog open_dialog(const std::filesystem::path& start) {
    FileDialog dialog;
    dialog.title = "Open an experiment folder, a mesh or a project";
    dialog.button = "Open";
    dialog.endings = {
        ".stl", ".obj", ".ply", ".vtp", ".vtu", ".vtk", ".msh", ".node", ".ele", ".toml", commands::project_ending};
    dialog.experiments = true;
    dialog.start = start;
    dialog.chosen = [](PanelContext& context, const std::filesystem::path& path) {
        context.emit(commands::Open{path, std::nullopt});
    };
    return dialog;
}

FileDialog experiment_dialog(const std::filesystem::path& mesh) {
    FileDialog dialog;
    dialog.title = "Make an experiment of this body, in a new folder";
    dialog.button = "Make";
    dialog.start = mesh;
    dialog.new_name = mesh.stem().string() + "_experiment";
    dialog.chosen = [](PanelContext& context, const std::filesystem::path& path) {
        context.emit(commands::MakeExperiment{path});
    };
    return dialog;
}

FileDialog recording_dialog(const std::filesystem::path& start) {
    FileDialog dialog;
    dialog.title = "Import a recording of motion capture";
    dialog.button = "Import";
    dialog.endings = measurement::trace_endings();
    dialog.start = start;
    dialog.chosen = [](PanelContext& context, const std::filesystem::path& path) {
        context.emit(commands::ReadRecording{path});
    };
    return dialog;
}

FileDialog save_dialog(const commands::WorkbenchState& state) {
    FileDialog dialog;
    dialog.title = "Save the project";
    dialog.button = "Save";
    dialog.endings = {commands::project_ending};
    dialog.start = state.project.empty() ? std::filesystem::path() : state.project;
    // A new project is proposed with the name of its experiment.
    dialog.new_name = state.project.empty() ? state.scene->path.stem().string() + commands::project_ending
                                            : state.project.filename().string();
    dialog.chosen = [](PanelContext& context, const std::filesystem::path& path) {
        context.emit(commands::SaveAs{path});
    };
    dialog.given_up = [](PanelContext& context) { context.emit(commands::AskWhereToSave{false}); };
    return dialog;
}

FileDialog picture_dialog(const PictureRequest& request, const std::string& name) {
    FileDialog dialog;
    dialog.title = request.moves ? "Save the motion in the 3D view" : "Save the 3D view as a picture";
    // The extension determines what is written, so another one must not be typed by accident.
    dialog.button = "Save";
    const std::string ending = std::filesystem::path(name).extension().string();
    if (!ending.empty()) dialog.endings = {ending};
    dialog.new_name = name;
    dialog.chosen = [request](PanelContext& context, const std::filesystem::path& path) {
        // The request is complete except for the path.
        PictureRequest asked = request;
        asked.path = path;
        context.window.picture = asked;
    };
    return dialog;
}

FileDialog part_surface_dialog(const commands::Scene& scene,
                               std::function<void(PanelContext&, const std::filesystem::path&)> chosen) {
    FileDialog dialog;
    dialog.title = "Choose the closed surface of the part";
    dialog.button = "Choose";
    dialog.endings = {".stl", ".obj", ".ply", ".vtp"};
    dialog.start = scene.path;
    dialog.chosen = std::move(chosen);
    return dialog;
}

FileDialog part_dialog(std::string title, const std::string& name, const platform::Rectangle& part) {
    FileDialog dialog;
    dialog.title = std::move(title);
    dialog.button = "Save";
    dialog.endings = {".png"};
    dialog.new_name = name + ".png";
    dialog.chosen = [part](PanelContext& context, const std::filesystem::path& path) {
        context.window.part = WindowPart{path, part};
    };
    return dialog;
}

FileDialog table_dialog(std::string title, const std::string& name, std::string table, const std::string& ending) {
    FileDialog dialog;
    dialog.title = std::move(title);
    dialog.button = "Save";
    dialog.endings = {ending};
    dialog.new_name = name + ending;
    // The text is stored now, so that the file contains what was shown when the dialog was opened.
    dialog.chosen = [table = std::move(table)](PanelContext& context, const std::filesystem::path& path) {
        // Writing a table is short, so it happens here and not in a job.
        const Result<void> written = write_file(path, table);
        context.emit(written
                         ? commands::LogMessage{commands::LogLevel::done, "Wrote " + path.string()}
                         : commands::LogMessage{commands::LogLevel::failure, "Cannot save: " + written.error().text()});
    };
    return dialog;
}

FileDialog body_dialog(const commands::ShapeExport& what, const std::string& name) {
    FileDialog dialog;
    dialog.title = "Export the body";
    dialog.button = "Save";
    dialog.endings = {std::filesystem::path(name).extension().string()};
    dialog.new_name = name;
    dialog.chosen = [what](PanelContext& context, const std::filesystem::path& path) {
        commands::ShapeExport asked = what;
        asked.path = path;
        context.emit(commands::ExportBody{asked});
    };
    return dialog;
}

FileDialog experiment_copy_dialog(const std::filesystem::path& experiment) {
    FileDialog dialog;
    dialog.title = "Save a copy of the experiment, in a new folder";
    dialog.button = "Save";
    dialog.start = experiment.parent_path();
    dialog.new_name = experiment.stem().string() + "_copy";
    dialog.chosen = [](PanelContext& context, const std::filesystem::path& path) {
        context.emit(commands::SaveExperimentAs{path});
    };
    return dialog;
}

FileDialog self_contained_dialog(const commands::WorkbenchState& state) {
    FileDialog dialog = save_dialog(state);
    dialog.title = "Save the project with body, recordings and results";
    dialog.chosen = [](PanelContext& context, const std::filesystem::path& path) {
        context.emit(commands::SaveAs{path, true});
    };
    dialog.given_up = {};
    return dialog;
}

FileDialog locate_dialog(const commands::MissingSource& missing) {
    FileDialog dialog = open_dialog(missing.project.parent_path());
    dialog.title = "Find " + missing.source.filename().string();
    // A project is no place for another one.
    std::erase(dialog.endings, commands::project_ending);
    dialog.chosen = [](PanelContext& context, const std::filesystem::path& path) {
        context.emit(commands::Locate{path});
    };
    dialog.given_up = [](PanelContext& context) { context.emit(commands::Locate{}); };
    return dialog;
}

}  // namespace myo::ui::panels
