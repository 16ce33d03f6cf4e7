#pragma once

#include "panels/panel.hpp"

// Edits of the declared markers, as the panel and the tool of the view make them.

namespace myo::ui::panels {

/// Whether any trial has a recording, which must hold every marker that is no probe.
bool has_recordings(const commands::Scene& scene);
/// Name for a new marker: `wanted` if no marker has it, else the first free of "wanted_1", "wanted_2", ...; the first
/// free of "m1", "m2", ... if `wanted` is empty.
std::string free_marker_name(const commands::Scene& scene, const std::string& wanted);

/// Adds a marker, or a probe where trials have recordings, and selects it. `rest_m`: place on the body at rest, in the
/// frame of the mesh.
void add_marker(PanelContext& context, const std::string& name, const Eigen::Vector3d& rest_m);
/// Moves a marker to another place at rest [m].
void move_marker(PanelContext& context, const commands::SceneMarker& marker, const Eigen::Vector3d& rest_m);
/// Removes a marker with its label.
void remove_marker(PanelContext& context, const commands::SceneMarker& marker);

/// Key of a marker's rest position in the declaration; probes have a table of their own.
toml::TomlPath marker_path(const commands::SceneMarker& marker);

}  // namespace myo::ui::panels
