#pragma once

#include <functional>

#include "effect/effect.hpp"

namespace myo::effect {

/// Multiplies the moduli at every point of the body by a function of where the point lies at rest, at least a
/// hundredth.
void scale_stiffness(const EffectSite& site, const std::function<double(const Eigen::Vector3d& point_m)>& factor,
                     Affected& affected);

}  // namespace myo::effect
