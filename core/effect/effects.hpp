#pragma once

#include "effect/effect.hpp"

namespace myo::effect {

// Constructors of the catalogue entries, one function per file.
Effect quadratic_drag();
Effect linear_drag();
Effect added_mass();
Effect point_mass();
Effect cable_tug();
Effect hung_mass();
Effect gravity_tilt();
Effect clamp_compliance();
Effect clamp_slip();
Effect held_pose();
Effect extra_damping();
Effect viscoelastic_creep();
Effect strain_stiffening_effect();
Effect stress_softening();
Effect stiffness_gradient();
Effect soft_patch();
Effect modulus_drift();
Effect intrinsic_curvature();
Effect actuation_lag();
Effect actuation_delay();
Effect actuation_gain();
Effect actuation_leak();
Effect actuation_hysteresis();
Effect clock_offset();
Effect frame_rate_error();
Effect scale_error();
Effect marker_swap();
Effect marker_slip();

}  // namespace myo::effect
