#pragma once

#include "material/material.hpp"

namespace myo::material {

/// A law whose distortional energy w = mu/2 (I1 - 3) grows by mu/2 c2 (I1 - 3)^2, I1 isochoric: w + 2 c2 w^2 / mu.
/// Stiffening for c2 > 0. Source: Yeoh 1990.
MaterialPointer strain_stiffening(MaterialPointer base, double yeoh_c2);

}  // namespace myo::material
