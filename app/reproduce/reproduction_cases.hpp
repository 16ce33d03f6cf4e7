#pragma once

#include "reproduce/reproduction.hpp"

namespace myo::reproduce {

// Builders of the cases, one per file reproduce_<id>.cpp; the summary is in the case itself.
ReproductionCase reproduce_beam_static();
ReproductionCase reproduce_beam_modulus();
ReproductionCase reproduce_numerical_damping();
ReproductionCase reproduce_lambda();
ReproductionCase reproduce_arm_static();
ReproductionCase reproduce_arm_dynamic();
ReproductionCase reproduce_arm_chamber();
ReproductionCase reproduce_fish();

}  // namespace myo::reproduce
