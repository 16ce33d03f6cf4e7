#pragma once

#include "fibre/fibre_group.hpp"

namespace myo::fibre {

/// The same fibres, cell by cell, where nodes of the mesh lie elsewhere at rest: their points, lines and volumes go
/// along with their cells.
///
/// Asserts that both meshes have the same cells and the group its gradients.
FibreGroup moved_fibres(const mesh::VolumeMesh& from, const mesh::VolumeMesh& to, FibreGroup group);

}  // namespace myo::fibre
