#pragma once

#include "model/model.hpp"

namespace myo::bench {

/// Hanging hollow cylinder, 43 x 43 x 96 mm of 3.57 mm cubes, with two antagonist muscles in the outer two layers of
/// cells.
///
/// Modelled on the pneumatic arm of the paper with its actuation AC2, a1 = 1 + 2 x and a2 = 1 - x; here x rises by 0.5
/// every 50 ms up to 2, the strongest actuation that the paper allows.
/// The upper end, at z = 96 mm, is clamped.
/// Source: Dubied et al. 2022, sec. V (geometry, stiffness of the muscles 200 kPa).
model::Model arm_model();

}  // namespace myo::bench
