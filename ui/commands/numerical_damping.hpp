#pragma once

namespace myo {

/// Damping ratio that implicit Euler gives to an undamped vibration of angular frequency omega [rad/s] at step h [s].
///
/// One step multiplies the amplitude by 1 / sqrt(1 + omega^2 h^2) and turns the phase by the angle of 1 + i omega h; the
/// logarithmic decrement over a full turn is delta = pi ln(1 + omega^2 h^2) / angle, and zeta = delta / sqrt(4 pi^2 + delta^2).
double implicit_euler_damping_ratio(double omega, double h);

}  // namespace myo
