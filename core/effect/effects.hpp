#pragma once

#include "effect/effect.hpp"

namespace myo::effect {

// Constructors of the catalogue entries, one function per file.

/// Force. Drag of a fluid at rest, traction proportional to |v| v, coefficient [kg/m3]. Absent at 0.
Effect quadratic_drag();
/// Force. Drag of a fluid at rest, traction proportional to v, coefficient [Pa s/m]. Absent at 0.
Effect linear_drag();
/// Force. Fluid that moves with the surface along its normal: inertia without weight, per area [kg/m2]. Absent at 0.
Effect added_mass();
/// Force. Undeclared mass at a point of the surface: inertia and weight [kg]. Absent at 0.
Effect point_mass();
/// Force. Cable as a linear spring between a surface point and a fixed anchor [N/m]. Absent at 0.
Effect cable_tug();
/// Force. Inertia of the body whose weight is a declared dead force, along the thread; ratio of the inertia to the
/// weight over g. Absent at 0.
Effect hung_mass();
/// Force. Gravity rotated by an angle [deg] about an axis. Absent at 0.
Effect gravity_tilt();
/// Support. Elastic bed under the clamped faces, stiffness per area [Pa/m]. Absent at infinity.
Effect clamp_compliance();
/// Support. The part of the clamp next to the free end does not hold, length [m]. Absent at 0.
Effect clamp_slip();
/// Support. Bent shape before the release, offset of the free end [m]. Absent at 0. Straight starts only.
Effect held_pose();
/// Material. Additional Kelvin-Voigt damping time [s]. Absent at 0.
Effect extra_damping();
/// Material. Maxwell branch in parallel with the elastic body: modulus ratio [-], relaxation time [s]. Absent at ratio
/// 0.
Effect viscoelastic_creep();
/// Material. Second term of the Yeoh law [-]. Absent at 0.
Effect strain_stiffening_effect();
/// Material. Softening with the largest energy density reached: damage [-], energy scale [J/m3]. Absent at damage 0.
Effect stress_softening();
/// Material. Modulus linear in one coordinate, relative change over the body. Absent at 0.
Effect stiffness_gradient();
/// Material. Modulus changed around a point, Gaussian of given radius [m], relative change. Absent at 0.
Effect soft_patch();
/// Material. Modulus linear in the session time [1/s]. Absent at 0.
Effect modulus_drift();
/// Material. Bent stress-free shape, curvature [1/m]. Absent at 0.
Effect intrinsic_curvature();
/// Actuation. First-order lag, time constant [s]. Absent at 0.
Effect actuation_lag();
/// Actuation. Dead time [s]. Absent at 0.
Effect actuation_delay();
/// Actuation. Relative change of the amplitude. Absent at 0.
Effect actuation_gain();
/// Actuation. Decay of a held input, time constant [s]. Absent at infinity.
Effect actuation_leak();
/// Actuation. Bouc-Wen hysteresis: fraction [-], width [-]. Absent at fraction 0.
Effect actuation_hysteresis();
/// Measurement. Constant error of the time stamps [s]. Absent at 0.
Effect clock_offset();
/// Measurement. Relative error of the frame rate. Absent at 0.
Effect frame_rate_error();
/// Measurement. Relative error of all coordinates. Absent at 0.
Effect scale_error();
/// Measurement. Two markers exchange their labels from a time on [s].
Effect marker_swap();
/// Measurement. A marker is displaced by a constant vector [m] from a time on [s].
Effect marker_slip();

}  // namespace myo::effect
