#pragma once

#include <Eigen/Core>

#include <vector>

#include "fem/element_block.hpp"

namespace myo::fem {

/// Shape functions at the quadrature points of an element, one vector per point.
std::vector<Eigen::VectorXd> shape_values_at_points(ElementKind kind);

}  // namespace myo::fem
