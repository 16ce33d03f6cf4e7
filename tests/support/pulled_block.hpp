#pragma once

#include "support/beam.hpp"

namespace myo::test {

/// A free cube so light that it follows its loads at once: what its material remembers is seen without inertia.
BeamSpec light_cube();

Eigen::VectorXd root_share(const model::Model& model, const BeamSpec& spec);

/// A stress [Pa] along x on both ends in [from_s, until_s).
void pull(model::Model& model, const BeamSpec& spec, double stress_Pa, double from_s = -1.0, double until_s = 1e9);

/// Mean strain along x.
double stretch_of(const model::Model& model, const BeamSpec& spec, const Eigen::Matrix3Xd& x);

}  // namespace myo::test
