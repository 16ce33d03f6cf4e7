#include "backend/examples.hpp"

#include <algorithm>
#include <cstdio>
#include <map>
#include <system_error>

#include "backend/core_scene.hpp"
#include "backend/project_file.hpp"
#include "base/text.hpp"
#include "project/read_experiment.hpp"

namespace myo {
namespace {

namespace fs = std::filesystem;

std::string size_label(std::uintmax_t bytes) {
    char text[32];
    if (bytes < 10000) std::snprintf(text, sizeof text, "%ju bytes", bytes);
    else if (bytes < 10000000) std::snprintf(text, sizeof text, "%.0f kB", 1e-3 * static_cast<double>(bytes));
    else std::snprintf(text, sizeof text, "%.0f MB", 1e-6 * static_cast<double>(bytes));
    return text;
}

std::vector<ReportLine> experiment_lines(const fs::path& path) {
    const Result<Experiment> experiment = read_experiment(path);
    if (!experiment) return {{"Cannot be opened", experiment.error().text(), true}};
    std::vector<std::string> trials, muscles;
    for (const TrialDeclaration& trial : experiment->trials) trials.push_back(trial.name + (trial.role == TrialRole::fit ? " (fit)" : " (validate)"));
    for (const MuscleDeclaration& muscle : experiment->muscles) muscles.push_back(muscle.name);
    std::vector<ReportLine> lines{{"Name", experiment->name}, {"Trials", join(trials)}, {"Markers", std::to_string(experiment->markers.on_body.size())}};
    if (!muscles.empty()) lines.push_back({"Muscles", join(muscles)});
    if (!experiment->description.empty()) lines.push_back({"Description", experiment->description});
    return lines;
}

std::vector<ReportLine> project_lines(const fs::path& path) {
    const Result<Project> project = read_project_file(path);
    if (!project) return {{"Cannot be opened", project.error().text(), true}};
    std::vector<std::string> muscles;
    for (const Muscle& muscle : project->settings.muscles) muscles.push_back(muscle.name);
    std::vector<ReportLine> lines{{"On", project->source.string()}, {"Elements", to_string(project->settings.element)}};
    if (!muscles.empty()) lines.push_back({"Muscles", join(muscles)});
    return lines;
}

}  // namespace

std::vector<Example> bundled_examples() {
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored).parent_path();
    std::vector<Example> examples;
    std::map<fs::path, std::size_t> trials;
    for (const fs::path& folder : {program / "../../assets/examples", program / "../share/myoloop/examples"}) {
        for (fs::directory_iterator it(folder, ignored), end; !ignored && it != end; it.increment(ignored)) {
            const fs::path home = fs::weakly_canonical(it->path(), ignored);
            if (!fs::is_regular_file(home / "experiment.toml", ignored)) continue;
            const Result<Experiment> experiment = read_experiment(home);
            if (!experiment) continue;
            examples.push_back({home, experiment->name, experiment->description});
            trials[home] = experiment->trials.size();
        }
        ignored.clear();
        if (!examples.empty()) break;
    }
    // What has most to look at comes first.
    std::sort(examples.begin(), examples.end(), [&](const Example& a, const Example& b) { return trials[a.path] != trials[b.path] ? trials[a.path] > trials[b.path] : a.path < b.path; });
    return examples;
}

std::vector<ReportLine> preview_of(const fs::path& path) {
    std::error_code ignored;
    if (is_project(path)) return project_lines(path);
    if (fs::is_regular_file(path / "experiment.toml", ignored) || path.extension() == ".toml") return experiment_lines(path);
    if (!fs::is_regular_file(path, ignored)) return {};
    return {{"Size", size_label(fs::file_size(path, ignored))}};
}

}  // namespace myo
