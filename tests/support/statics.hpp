#pragma once

#include "model/model.hpp"
#include "support/beam.hpp"

namespace myo::test {

/// Node positions in static equilibrium, 3 x n [m]. Fails the test if no equilibrium is found.
Eigen::Matrix3Xd equilibrium(const model::Model& model);

/// Mean displacement of the end face [m] in static equilibrium. Fails the test if no equilibrium is found.
Eigen::Vector3d tip_at_equilibrium(const model::Model& model, const BeamSpec& spec);

}  // namespace myo::test
