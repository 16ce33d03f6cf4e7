#pragma once

#include "fibre/fibre_group.hpp"

namespace myo {

/// The same fibres, cell by cell, where nodes of the mesh lie elsewhere at rest: their points, lines and volumes go along with their cells.
///
/// Asserts that both meshes have the same cells and the group its gradients.
FibreGroup moved_fibres(const VolumeMesh& from, const VolumeMesh& to, FibreGroup group);

}  // namespace myo
