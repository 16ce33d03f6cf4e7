#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"
#include "experiment/experiment.hpp"
#include "fibre/fibre_group.hpp"
#include "setup/body_mesh.hpp"

namespace myo::setup {

/// The declared muscles on a mesh, in their order.
/// @param warnings  gets a sentence for each thing a mask says that cannot be so, and for paint that lies off the body;
/// may be null
/// Errors: a mask that cannot be read (place: its line), a mask or a line that meets no material (place: the key's
/// line).
Result<std::vector<fibre::FibreGroup>> muscle_groups(const experiment::Experiment& experiment, const BodyMesh& mesh,
                                                     std::vector<std::string>* warnings = nullptr);

}  // namespace myo::setup
