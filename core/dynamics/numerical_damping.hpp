#pragma once

#include <Eigen/Core>

#include "dynamics/integrator.hpp"

namespace myo::dynamics {

/// Test equation x'' + 2 zeta omega x' + omega^2 x = Lambda x': one mode of a body. The damping enters as strain-rate
/// damping does in the model, Lambda as the velocity force.
struct Oscillator {
    double omega_rad_s = 0.0;
    double damping_ratio = 0.0;       // zeta
    double velocity_force_1_s = 0.0;  // Lambda
};

/// Amplification matrix of one step of length h that follows steps of the same length.
///
/// Acts on (x, h v, h v_lag, h^2 force_lag) of Kinematics. Its columns are computed with the integrator's own step, so
/// it cannot disagree with the runs.
Eigen::Matrix4d amplification(const TimeScheme& scheme, const Oscillator& oscillator, double h_s);

/// Damping and frequency of the discrete motion exp(s t) of an oscillator.
struct DiscreteVibration {
    double damping_ratio = 0.0;    // -Re s / |s|; for an undamped oscillator this is the numerical damping
    double frequency_error = 0.0;  // Im s over the exact damped frequency, minus 1
    double spectral_radius = 0.0;  // of the amplification matrix; unstable above 1
};

/// Discrete motion of the principal root, which is tracked from small steps up to h.
///
/// Errors: asserts omega > 0, h > 0 and an oscillating motion (total damping ratio between -1 and 1).
DiscreteVibration discrete_vibration(const TimeScheme& scheme, const Oscillator& oscillator, double h_s);

/// Numerical damping ratio of implicit Euler for an undamped oscillator, in closed form.
///
/// zeta = delta / sqrt(4 pi^2 + delta^2) with the logarithmic decrement delta = pi ln(1 + omega^2 h^2) / angle(1 + i
/// omega h).
/// Source: Dubied et al. 2022, sec. IV-B.
double implicit_euler_numerical_damping(double omega_rad_s, double h_s);

/// Stability limit of implicit Euler: largest Lambda [1/s] without growth, h omega^2 + 2 zeta omega.
///
/// The velocity force uses the velocity at the start of the step, as in the paper:
///   (x1, v1) = 1 / D ((1 + 2 zeta omega h, h (1 + h Lambda)), (-h omega^2, 1 + h Lambda)) (x0, v0),
///   D = 1 + h^2 omega^2 + 2 zeta omega h.
/// The conjugate roots have the squared modulus det = (1 + h Lambda) / D. With the velocity at the end of the step, as
/// in the paper's stability analysis, det = 1 / (D - h Lambda): the same limit.
double implicit_euler_critical_velocity_force(double omega_rad_s, double h_s, double damping_ratio = 0.0);

/// Stability limit of any integrator: least Lambda [1/s] above which the spectral radius exceeds 1.
///
/// Accurate to 1e-9 omega (bisection). Infinite if there is no growth up to Lambda = 1000 (omega + 1/h): an implicit
/// scheme damps motions that grow too fast for its step.
double critical_velocity_force(const TimeScheme& scheme, double omega_rad_s, double h_s, double damping_ratio = 0.0);

}  // namespace myo::dynamics
