#pragma once

#include <vector>

#include "base/result.hpp"
#include "fibre/fibre_group.hpp"
#include "project/experiment.hpp"
#include "project/study_mesh.hpp"

namespace myo {

/// The declared muscles on a mesh, in their order.
/// Errors: a mask that cannot be read (place: its line), a mask or a line that meets no material (place: the key's line).
Result<std::vector<FibreGroup>> muscle_groups(const Experiment& experiment, const StudyMesh& mesh);

}  // namespace myo
