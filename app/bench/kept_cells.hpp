#pragma once

#include <Eigen/Core>

#include <functional>

#include "mesh/volume_mesh.hpp"

namespace myo::bench {

/// Submesh of the cells at whose midpoint [m], the mean of their nodes, `keep` holds, with the nodes that they use,
/// renumbered in the order of first use. The order of the cells stays.
mesh::VolumeMesh kept_cells(const mesh::VolumeMesh& mesh, const std::function<bool(const Eigen::Vector3d&)>& keep);

}  // namespace myo::bench
