#pragma once

#include <vector>

#include "model/body.hpp"

namespace myo::model {

/// Clamped nodes of a body.
///
/// @return  node numbers, ascending
std::vector<int> held_nodes(const Body& body);

}  // namespace myo::model
