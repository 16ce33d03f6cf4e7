#pragma once

#include <Eigen/Core>

#include "model/body.hpp"

namespace myo::model {

/// Rest positions of all points of a body, where its law is evaluated, 3 x point_count [m]; see Body::point_entry.
Eigen::Matrix3Xd rest_points(const Body& body);

}  // namespace myo::model
