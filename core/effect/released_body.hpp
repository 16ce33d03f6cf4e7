#pragma once

#include <vector>

#include "model/body.hpp"

namespace myo {

/// The same body, free at nodes that were clamped.
BodyPointer released_body(const Body& body, const std::vector<int>& nodes);

}  // namespace myo
