#pragma once

#include <functional>

#include "effect/effect.hpp"

namespace myo::effect {

/// Multiplies the moduli at every quadrature point by a function of its rest position [m]; the factor is at least 0.01.
/// Scales mu and kappa by one factor. The element must have points enough to resolve the function
/// (varies_within_cells).
void scale_stiffness(const TrialContext& context, const std::function<double(const Eigen::Vector3d& point_m)>& factor,
                     Affected& affected);

}  // namespace myo::effect
