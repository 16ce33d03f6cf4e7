#pragma once

#include <vector>

#include "model/body.hpp"

namespace myo::effect {

/// The same body, free at nodes that were clamped.
model::BodyPointer released_body(const model::Body& body, const std::vector<int>& nodes);

/// The same body with its nodes elsewhere at rest, 3 x n [m]: the same cells, held at the same nodes.
model::BodyPointer on_nodes(const model::Body& body, Eigen::Matrix3Xd nodes_m);

/// A body of other elements with the same nodes, held at the same ones.
model::BodyPointer of_kind(const model::Body& body, fem::ElementKind kind);

}  // namespace myo::effect
