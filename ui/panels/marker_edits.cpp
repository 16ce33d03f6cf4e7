#include "panels/marker_edits.hpp"

#include <algorithm>

#include "commands/place_text.hpp"

namespace myo::ui::panels {

bool has_recordings(const commands::Scene& scene) {
    return std::any_of(scene.trials.begin(), scene.trials.end(),
                       [](const commands::SceneTrial& trial) { return trial.role != "simulate"; });
}

std::string free_marker_name(const commands::Scene& scene, const std::string& wanted) {
    const auto taken = [&](const std::string& name) {
        return std::any_of(scene.markers.begin(), scene.markers.end(),
                           [&](const commands::SceneMarker& marker) { return marker.name == name; });
    };
    if (!wanted.empty() && !taken(wanted)) return wanted;
    for (int k = 1;; ++k)
        if (const std::string name = (wanted.empty() ? "m" : wanted + "_") + std::to_string(k); !taken(name))
            return name;
}

void add_marker(PanelContext& context, const std::string& name, const Eigen::Vector3d& rest_m) {
    const commands::Scene& scene = *context.state.scene;
    const commands::SceneMarker added{name, rest_m, name, has_recordings(scene)};
    context.emit(commands::EditDeclaration{{commands::SetDeclared{marker_path(added), commands::place_text(rest_m)}},
                                           "probe/add"});
    // Probes stand behind the markers that recordings hold: a new marker is the last before them, a new probe the last
    // of all. The command is executed after the edit, when the marker exists.
    const auto before = std::count_if(scene.markers.begin(), scene.markers.end(),
                                      [&](const commands::SceneMarker& m) { return added.probe || !m.probe; });
    context.emit(commands::ChooseMarker{static_cast<int>(before)});
}

void move_marker(PanelContext& context, const commands::SceneMarker& marker, const Eigen::Vector3d& rest_m) {
    context.emit(commands::EditDeclaration{{commands::SetDeclared{marker_path(marker), commands::place_text(rest_m)}},
                                           "probe/drag/" + marker.name});
}

void remove_marker(PanelContext& context, const commands::SceneMarker& marker) {
    context.emit(commands::EditDeclaration{
        {commands::RemoveDeclared{marker_path(marker)}, commands::RemoveDeclared{{"markers", "labels", marker.name}}},
        "probe/remove"});
}

toml::TomlPath marker_path(const commands::SceneMarker& marker) {
    return {"markers", marker.probe ? "probe_m" : "rest_m", marker.name};
}

}  // namespace myo::ui::panels
