#pragma once

#include <vector>

#include "model/body.hpp"

namespace myo::model {

/// Clamped nodes of a body.
///
/// @return  node numbers, ascending
std::vector<int> held_nodes(const Body& body);

/// Nodes that show where the body is supported: the clamped ones, without any the guided ones.
///
/// @return  node numbers, ascending; empty if nothing holds the body
std::vector<int> support_nodes(const Body& body);

}  // namespace myo::model
