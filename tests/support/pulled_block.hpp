#pragma once

#include "support/beam.hpp"

namespace myo::test {

/// A free cube with so little mass that it follows its loads at once. Tests see the memory of its material without
/// inertia.
BeamSpec light_cube();

/// Weights of the nodes in the mean over the end face at x = 0, sum 1.
Eigen::VectorXd root_share(const model::Model& model, const BeamSpec& spec);

/// Applies opposite stresses [Pa] along x to both ends for times in [from_s, until_s).
void pull(model::Model& model, const BeamSpec& spec, double stress_Pa, double from_s = -1.0, double until_s = 1e9);

/// Mean engineering strain along x.
double stretch_of(const model::Model& model, const BeamSpec& spec, const Eigen::Matrix3Xd& x);

}  // namespace myo::test
