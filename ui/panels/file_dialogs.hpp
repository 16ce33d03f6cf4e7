#pragma once

#include "panels/panel.hpp"

namespace myo {

/// Opens an experiment, a mesh or a project; begins at a place.
FileDialog open_dialog(const std::filesystem::path& start);
/// Saves the project under a name.
FileDialog save_dialog(const WorkbenchState& state);
/// Saves the 3D view.
FileDialog picture_dialog();

}  // namespace myo
