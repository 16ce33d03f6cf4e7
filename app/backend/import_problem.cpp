#include "backend/import_problem.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <set>

#include "backend/core_scene.hpp"
#include "backend/examples.hpp"
#include "backend/recording_import.hpp"

namespace myo::backend {

namespace fs = std::filesystem;
using Eigen::Index;

namespace {

/// Whether the scene is a bundled example, which must not be modified.
bool is_bundled(const ui::commands::Scene& scene) {
    // Constant while the program runs, and too slow to be read again for every change of a choice.
    static const std::vector<ui::commands::Example> examples = bundled_examples();
    std::error_code ignored;
    return std::any_of(examples.begin(), examples.end(), [&](const ui::commands::Example& example) {
        return fs::equivalent(example.path, scene.path, ignored);
    });
}

/// Why the marker cannot have its label; empty: it can.
std::string problem_of_marker(const ui::commands::Scene& scene, const ui::commands::ImportedMarker& marker,
                              const ui::commands::ImportView& view, Index label) {
    if (has_markers(scene) && !marker_named(declared_scene_markers(scene), marker.name))
        return "The experiment has no marker " + marker.name + ".";
    if (!view.target_m.col(label).allFinite()) return "The marker " + marker.name + " has no place on the body yet.";
    // A new marker needs a rest position, which is the mean of its samples before the start.
    if (!has_markers(scene) && !view.before_m.col(label).allFinite())
        return "The marker " + marker.name + " is not seen before the start; leave it out.";
    return "";
}

}  // namespace

bool has_trials(const ui::commands::Scene& scene) { return !source_of(scene).experiment.trials.empty(); }

bool has_markers(const ui::commands::Scene& scene) {
    return has_trials(scene) && !declared_scene_markers(scene).empty();
}

Eigen::Matrix3d axes_rotation(const std::array<int, 3>& axes) {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Zero();
    for (int i = 0; i < 3; ++i)
        rotation(i, std::abs(axes[static_cast<std::size_t>(i)]) - 1) = axes[static_cast<std::size_t>(i)] > 0 ? 1.0
                                                                                                             : -1.0;
    return rotation;
}

const ui::commands::SceneMarker* marker_named(const std::vector<ui::commands::SceneMarker>& markers,
                                              const std::string& name) {
    const auto found = std::find_if(markers.begin(), markers.end(),
                                    [&](const ui::commands::SceneMarker& m) { return m.name == name; });
    return found != markers.end() ? &*found : nullptr;
}

std::string import_problem(const ui::commands::Scene& scene, const ui::commands::ImportChoices& choices,
                           const ui::commands::ImportView& view) {
    // A signed permutation has determinant 1 or -1; -1 is a reflection, 0 a repeated axis.
    if (axes_rotation(choices.axes).determinant() < 0.5) return "The axes mirror the body: reverse one of them.";
    std::set<std::string> names;
    for (std::size_t i = 0; i < choices.markers.size(); ++i) {
        const ui::commands::ImportedMarker& marker = choices.markers[i];
        if (marker.name.empty()) continue;
        if (!names.insert(marker.name).second) return "Two labels are assigned to the marker " + marker.name + ".";
        if (const std::string problem = problem_of_marker(scene, marker, view, static_cast<Index>(i)); !problem.empty())
            return problem;
    }
    if (names.empty()) return "No label is assigned to a marker yet.";
    const experiment::Experiment& experiment = source_of(scene).experiment;
    // Displacements are relative to the rest pose, so every marker of the body must be visible before the start.
    if (has_trials(scene) && experiment.markers.compare == experiment::Comparison::displacement)
        for (const experiment::MarkerDeclaration& own : experiment.markers.on_body) {
            // No recording holds a probe.
            if (own.probe) continue;
            const auto found = std::find_if(choices.markers.begin(), choices.markers.end(),
                                            [&](const ui::commands::ImportedMarker& m) { return m.name == own.name; });
            if (found == choices.markers.end() || !view.before_m.col(found - choices.markers.begin()).allFinite())
                return "This experiment compares displacements, so " + own.name + " must be seen before the start.";
        }
    if (choices.trial.empty()) return "The trial has no name.";
    const auto& trials = experiment.trials;
    if (std::any_of(trials.begin(), trials.end(),
                    [&](const experiment::TrialDeclaration& trial) { return trial.name == choices.trial; }))
        return "The experiment has a trial " + choices.trial + " already: choose another name.";
    if (!has_trials(scene) && choices.folder.empty()) return "Choose a new folder for the experiment.";
    if (is_bundled(scene) && choices.folder.empty())
        return "Bundled examples are not changed: choose a folder for a copy of this one.";
    return "";
}

}  // namespace myo::backend
