#pragma once

#include <Eigen/Core>

#include "model/body.hpp"

namespace myo::model {

/// Rest positions of all points of a body, where its law is evaluated.
///
/// @return  3 x point_count [m]; order as in Body::point_entry, padding included
Eigen::Matrix3Xd rest_points(const Body& body);

}  // namespace myo::model
