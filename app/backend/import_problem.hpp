#pragma once

#include <Eigen/Core>

#include <array>
#include <string>
#include <vector>

#include "commands/backend.hpp"
#include "commands/recording_import.hpp"

namespace myo::backend {

/// Whether the scene is an experiment with trials, to which a recording can be added.
bool has_trials(const ui::commands::Scene& scene);

/// Whether the markers are those of the experiment. A plain mesh, or an experiment that declares none yet, takes the
/// markers that the user places during the import.
bool has_markers(const ui::commands::Scene& scene);

/// Matrix from recorded axes to those of the body: axes[i] is the recorded axis (1 ... 3, negative: reversed) that
/// becomes axis i. A signed permutation if no axis is repeated; a rotation only if its determinant is 1.
Eigen::Matrix3d axes_rotation(const std::array<int, 3>& axes);

/// The marker with this name, or null. The pointer is valid as long as `markers`.
const ui::commands::SceneMarker* marker_named(const std::vector<ui::commands::SceneMarker>& markers,
                                              const std::string& name);

/// First reason why the choices cannot become a trial, a sentence; empty if they can.
///
/// @param view  all of it but its problem
std::string import_problem(const ui::commands::Scene& scene, const ui::commands::ImportChoices& choices,
                           const ui::commands::ImportView& view);

}  // namespace myo::backend
