#pragma once

#include "material/material.hpp"

namespace myo::material {

/// Law `base` with an additional energy mu/2 c2 (I1 - 3)^2, with isochoric I1. With the distortional energy w = mu/2
/// (I1 - 3) the sum is w + 2 c2 w^2 / mu.
///
/// @param yeoh_c2  dimensionless; > 0 stiffens
/// Source: Yeoh 1990.
MaterialPointer strain_stiffening(MaterialPointer base, double yeoh_c2);

}  // namespace myo::material
