#pragma once

#include "fibre/fibre_group.hpp"

namespace myo::fibre {

/// Fibre group after a change of the rest positions of the nodes: points, directions and volumes are mapped with their
/// cells.
///
/// @param from, to  meshes with the same cells (asserted)
/// @param group     must have its gradients (asserted)
FibreGroup moved_fibres(const mesh::VolumeMesh& from, const mesh::VolumeMesh& to, FibreGroup group);

}  // namespace myo::fibre
