#pragma once

#include "model/model.hpp"
#include "support/beam.hpp"

namespace myo::test {

/// Mean displacement of the end face where a beam rests under its loads [m]; fails the test where it finds no rest.
Eigen::Vector3d tip_at_equilibrium(const model::Model& model, const BeamSpec& spec);

}  // namespace myo::test
