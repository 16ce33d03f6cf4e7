#pragma once

#include <vector>

#include "model/body.hpp"

namespace myo::effect {

/// Copy of the body in which the given clamped nodes are free.
model::BodyPointer released_body(const model::Body& body, const std::vector<int>& nodes);

/// Copy of the body with other rest positions, 3 x n [m]; cells and clamped nodes are the same.
/// Mass, volumes and shape functions are computed for them. Cells must stay valid (positive volume).
model::BodyPointer on_nodes(const model::Body& body, Eigen::Matrix3Xd nodes_m);

/// Copy of the body with another element formulation on the same nodes, clamped at the same ones.
model::BodyPointer of_kind(const model::Body& body, fem::ElementKind kind);

}  // namespace myo::effect
