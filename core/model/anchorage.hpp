#pragma once

#include "model/force_element.hpp"

namespace myo {

/// Springs that hold the body's volume in its place: energy k/2 |x - X|^2 per rest volume, lumped at the nodes.
///
/// @param fraction  per cell, the part of its volume that is held
/// Parameter: stiffness_Pa_per_m2, positive.
ForceElementPointer anchorage(const Body& body, const Eigen::VectorXd& fraction, double stiffness_Pa_per_m2);

}  // namespace myo
