#pragma once

#include "commands/backend.hpp"
#include "experiment/experiment.hpp"
#include "setup/body_mesh.hpp"

namespace myo::backend {

/// Fills in the effects, obstacles and parts of an experiment; those that the scene had are replaced.
///
/// @param surface  of the body [m]; its bounds give places to new effects
/// @param time_s   within the first trial [s], for new effects that are events
void show_declared(const experiment::Experiment& experiment, const mesh::SurfaceMesh& surface, double time_s,
                   ui::commands::Scene& scene);

/// Shares of the materials in the cells of a mesh, see setup::part_shares(); empty if the parts do not fit the mesh.
Eigen::MatrixXd shown_part_shares(const experiment::Experiment& experiment, const setup::BodyMesh& mesh);

}  // namespace myo::backend
