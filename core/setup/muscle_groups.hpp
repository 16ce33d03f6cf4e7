#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"
#include "experiment/experiment.hpp"
#include "fibre/fibre_group.hpp"
#include "setup/body_mesh.hpp"

namespace myo::setup {

/// Fibres of the declared muscles on a mesh, in the order of declaration.
///
/// @param warnings  receives a sentence for each contradiction in a mask and for paint outside the body; may be null
/// Errors: a mask that cannot be read (place: its line), a mask or a line without material (place: line of the key). A
/// mask without any paint is no error, as it is being painted.
Result<std::vector<fibre::FibreGroup>> muscle_groups(const experiment::Experiment& experiment, const BodyMesh& mesh,
                                                     std::vector<std::string>* warnings = nullptr);

}  // namespace myo::setup
