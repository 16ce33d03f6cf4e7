#pragma once

#include "reproduce/reproduction.hpp"

namespace myo::reproduce {

// Builders of the cases, one per file reproduce_<id>.cpp; the summary is in the case itself.

/// Tip deflection of the paper's cases A-1 to E, with the errors that cancel. Recordings of the beam add a column.
ReproductionCase reproduce_beam_static();
/// Young's modulus of the loaded beam from random starts. Without recordings of the beam, only the fit to the
/// commercial solver.
ReproductionCase reproduce_beam_modulus();
/// Numerical damping of implicit Euler against the paper's formula. Recordings of the beam add the measured damping.
ReproductionCase reproduce_numerical_damping();
/// Velocity force that compensates this damping.
ReproductionCase reproduce_lambda();
/// Map from pressure to muscle signals in equilibrium. Needs the geometry of the arm; without the pressure sweep only
/// the response of the models is shown.
ReproductionCase reproduce_arm_static();
/// Muscle signals that follow a recorded motion of the arm. Needs its geometry and a recording.
ReproductionCase reproduce_arm_dynamic();
/// Pressure chambers against muscle models. Needs no data; recordings add the real arm.
ReproductionCase reproduce_arm_chamber();
/// Muscle signals that follow a recorded motion of the fish tail. Needs its geometry and the recording.
ReproductionCase reproduce_fish();

}  // namespace myo::reproduce
