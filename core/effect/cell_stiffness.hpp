#pragma once

#include <functional>

#include "effect/effect.hpp"

namespace myo {

/// Multiplies the moduli of every cell by a function of its centre, at least a hundredth.
void scale_stiffness(const EffectSite& site, const std::function<double(const Eigen::Vector3d& centre_m)>& factor, Affected& affected);

}  // namespace myo
