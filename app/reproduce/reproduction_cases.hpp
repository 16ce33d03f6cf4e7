#pragma once

#include "reproduce/reproduction.hpp"

namespace myo::reproduce {

// Builders of the cases, one per file reproduce_<id>.cpp; the summary is in the case itself.

/// Tip deflection of the paper's cases A-1 to E, with the errors that cancel.
ReproductionCase reproduce_beam_static();
/// Young's modulus of the loaded beam from random starts.
ReproductionCase reproduce_beam_modulus();
/// Numerical damping of implicit Euler against the paper's formula.
ReproductionCase reproduce_numerical_damping();
/// Velocity force that compensates this damping.
ReproductionCase reproduce_lambda();
/// Map from pressure to muscle signals in equilibrium.
ReproductionCase reproduce_arm_static();
/// Muscle signals that follow a recorded motion of the arm.
ReproductionCase reproduce_arm_dynamic();
/// Pressure chambers against muscle models.
ReproductionCase reproduce_arm_chamber();
/// Muscle signals that follow a recorded motion of the fish tail.
ReproductionCase reproduce_fish();

}  // namespace myo::reproduce
