#pragma once

#include <vector>

#include "base/result.hpp"
#include "experiment/experiment.hpp"
#include "model/block_pattern.hpp"
#include "setup/body_mesh.hpp"

namespace myo::setup {

/// Nodes of a mesh that a declaration holds.
struct HeldNodes {
    std::vector<int> clamped;               // along all axes; a node may occur twice
    std::vector<model::GuidedNode> guided;  // along some axes; a node may occur twice
};

/// Nodes in the boxes of clamp and supports.
///
/// @param body  bounds of the declared body [m]
/// Errors, with key and line: a box without a node, as the body would fall; all nodes clamped, as nothing could move. A
/// body without clamp and supports has none.
Result<HeldNodes> held_nodes(const experiment::Experiment& experiment, const BodyMesh& mesh, const Box& body);

}  // namespace myo::setup
