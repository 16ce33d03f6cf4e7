#pragma once

#include <Eigen/Core>

#include "model/body.hpp"

namespace myo::model {

/// Where the points of a body, at which its law is evaluated, lie at rest, 3 x point_count [m]; see Body::point_entry.
Eigen::Matrix3Xd rest_points(const Body& body);

}  // namespace myo::model
