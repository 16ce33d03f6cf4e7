#include "backend/file_preview.hpp"

#include <algorithm>
#include <cstdio>
#include <system_error>

#include "backend/core_scene.hpp"
#include "backend/project_file.hpp"
#include "backend/recording_import.hpp"
#include "base/text.hpp"
#include "experiment/read_experiment.hpp"
#include "measurement/trace_file.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/surface_reader.hpp"
#include "mesh/volume_reader.hpp"

namespace myo::backend {
namespace {

namespace fs = std::filesystem;

/// Larger files are not read for a preview; this size takes some tens of milliseconds [bytes].
constexpr std::uintmax_t largest_read = 8'000'000;

/// Size of a file in words, with decimal prefixes: "812 kB".
std::string size_label(std::uintmax_t bytes) {
    char text[32];
    if (bytes < 10000)
        std::snprintf(text, sizeof text, "%ju bytes", bytes);
    else if (bytes < 10000000)
        std::snprintf(text, sizeof text, "%.0f kB", 1e-3 * static_cast<double>(bytes));
    else
        std::snprintf(text, sizeof text, "%.0f MB", 1e-6 * static_cast<double>(bytes));
    return text;
}

/// Line with the reason of an error, marked as a warning.
ui::commands::ReportLine cannot_be_opened(const Error& error) { return {"Cannot be opened", error.text(), true}; }

/// Name, trials with role, number of markers and actuators of an experiment. Traces are not read.
std::vector<ui::commands::ReportLine> experiment_lines(const fs::path& path) {
    const Result<experiment::Experiment> experiment = experiment::read_experiment(path);
    if (!experiment) return {cannot_be_opened(experiment.error())};
    std::vector<std::string> trials, muscles, chambers, tendons;
    for (const experiment::TrialDeclaration& trial : experiment->trials)
        trials.push_back(trial.name + " (" + to_string(trial.role) + ")");
    for (const experiment::MuscleDeclaration& muscle : experiment->muscles) muscles.push_back(muscle.name);
    for (const experiment::ChamberDeclaration& chamber : experiment->chambers) chambers.push_back(chamber.name);
    for (const experiment::TendonDeclaration& tendon : experiment->tendons) tendons.push_back(tendon.name);
    std::vector<ui::commands::ReportLine> lines{{"Name", experiment->name},
                                                {"Trials", join(trials)},
                                                {"Markers", std::to_string(experiment->markers.on_body.size())}};
    if (!muscles.empty()) lines.push_back({"Muscles", join(muscles)});
    if (!chambers.empty()) lines.push_back({"Chambers", join(chambers)});
    if (!tendons.empty()) lines.push_back({"Tendons", join(tendons)});
    if (!experiment->description.empty()) lines.push_back({"Description", experiment->description});
    return lines;
}

/// Source, element and muscles of a project.
std::vector<ui::commands::ReportLine> project_lines(const fs::path& path) {
    const Result<ui::commands::Project> project = read_project_file(path);
    if (!project) return {cannot_be_opened(project.error())};
    std::vector<std::string> muscles;
    for (const ui::commands::Muscle& muscle : project->settings.muscles) muscles.push_back(muscle.name);
    std::vector<ui::commands::ReportLine> lines{{"On", project->source.string()},
                                                {"Elements", to_string(project->settings.element)}};
    if (!muscles.empty()) lines.push_back({"Muscles", join(muscles)});
    return lines;
}

/// Meshes do not store a unit: sizes are listed for each unit that gives a plausible body.
void add_sizes(const Eigen::Matrix3Xd& places, std::vector<ui::commands::ReportLine>& lines) {
    const Eigen::Vector3d size = mesh::bounding_box(places).size();
    struct Unit {
        const char* label;
        double metres;
    };
    for (const Unit& unit : {Unit{"Size, read as millimetres", 1e-3}, Unit{"Size, read as metres", 1.0}}) {
        const Eigen::Vector3d mm = 1e3 * unit.metres * size;
        if (mesh::check_plausible_size(1e-3 * mm))
            lines.push_back({unit.label, format_number(mm(0), 4) + " × " + format_number(mm(1), 4) + " × " +
                                             format_number(mm(2), 4) + " mm"});
    }
}

/// Size and counts of a mesh, read with 1 m per unit.
std::vector<ui::commands::ReportLine> mesh_lines(const fs::path& path) {
    std::vector<ui::commands::ReportLine> lines;
    if (is_volume_file(path)) {
        const Result<mesh::VolumeMesh> mesh = mesh::read_volume(path, 1.0);
        if (!mesh) return {cannot_be_opened(mesh.error())};
        add_sizes(mesh->nodes, lines);
        lines.push_back({"Elements", std::to_string(mesh->cell_count()) + " " + to_string(mesh->type)});
        lines.push_back({"Nodes", std::to_string(mesh->node_count())});
        return lines;
    }
    const Result<mesh::SurfaceMesh> surface = mesh::read_surface(path, 1.0);
    if (!surface) return {cannot_be_opened(surface.error())};
    add_sizes(surface->vertices, lines);
    lines.push_back({"Triangles", std::to_string(surface->triangles.cols())});
    return lines;
}

/// Format, markers, frames, rate and duration of a recording.
std::vector<ui::commands::ReportLine> recording_lines(const fs::path& path) {
    const Result<ui::commands::RecordingFile> file = read_recording_file(path, {});
    if (!file) return {};  // other tables have the same extensions
    const measurement::Recording& recording = *file->recording;
    constexpr std::size_t max_names = 8;
    // The line has room for a few names only.
    std::vector<std::string> names(
        recording.labels.begin(),
        recording.labels.begin() + static_cast<std::ptrdiff_t>(std::min(recording.labels.size(), max_names)));
    if (names.size() < recording.labels.size()) names.emplace_back("…");
    std::vector<ui::commands::ReportLine> lines{
        {"Format", file->format},
        {"Markers", std::to_string(recording.labels.size()) + ": " + join(names)},
        {"Frames", std::to_string(recording.sample_count())}};
    // read_recording_file() assumes a rate for such files; a duration from it would be made up.
    if (file->asks_rate) {
        lines.push_back({"Rate", "not in the file"});
        return lines;
    }
    lines.push_back({"Rate", format_number(recording.rate_Hz, 4) + " Hz"});
    lines.push_back(
        {"Duration", format_number(recording.time_s(recording.time_s.size() - 1) - recording.time_s(0), 4) + " s"});
    return lines;
}

}  // namespace

std::vector<ui::commands::ReportLine> preview_of(const fs::path& path) {
    std::error_code ignored;
    if (ui::commands::is_project(path)) return project_lines(path);
    if (fs::is_regular_file(path / "experiment.toml", ignored) || path.extension() == ".toml")
        return experiment_lines(path);
    if (!fs::is_regular_file(path, ignored)) return {};
    const std::uintmax_t bytes = fs::file_size(path, ignored);
    std::vector<ui::commands::ReportLine> lines;
    if (bytes <= largest_read && is_mesh_file(path)) lines = mesh_lines(path);
    if (bytes <= largest_read && measurement::has_trace_ending(path)) lines = recording_lines(path);
    lines.push_back({"File", size_label(bytes)});
    return lines;
}

}  // namespace myo::backend
