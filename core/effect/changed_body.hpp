#pragma once

#include <vector>

#include "model/body.hpp"

namespace myo {

/// The same body, free at nodes that were clamped.
BodyPointer released_body(const Body& body, const std::vector<int>& nodes);

/// The same body with its nodes elsewhere at rest, 3 x n [m]: the same cells, held at the same nodes.
BodyPointer on_nodes(const Body& body, Eigen::Matrix3Xd nodes_m);

/// A body of other elements with the same nodes, held at the same ones.
BodyPointer of_kind(const Body& body, ElementKind kind);

}  // namespace myo
