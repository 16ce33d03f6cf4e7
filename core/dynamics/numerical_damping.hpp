#pragma once

#include <Eigen/Core>

#include "dynamics/integrator.hpp"

namespace myo::dynamics {

/// x'' + 2 zeta omega x' + omega^2 x = Lambda x': one vibration of a body. The damping acts as strain-rate damping does
/// in the model, Lambda as its velocity force.
struct Oscillator {
    double omega_rad_s = 0.0;
    double damping_ratio = 0.0;       // zeta
    double velocity_force_1_s = 0.0;  // Lambda
};

/// The matrix of one step of length h after steps of the same length, for (x, h v, h v_lag, h^2 force_lag) of
/// Kinematics. It is made by taking the integrator's own step, so it cannot disagree with the runs.
Eigen::Matrix4d amplification(const TimeScheme& scheme, const Oscillator& oscillator, double h_s);

/// What an integrator makes of a vibration.
struct DiscreteVibration {
    double damping_ratio = 0.0;    // -Re s / |s| of the discrete motion exp(s t); the numerical damping where the
                                   // oscillator has none
    double frequency_error = 0.0;  // Im s over the exact one, less 1
    double spectral_radius = 0.0;  // of the step; above 1 it grows
};

/// The principal root, followed from short steps to h. Asserts an oscillator that swings (total damping ratio within -1
/// ... 1).
DiscreteVibration discrete_vibration(const TimeScheme& scheme, const Oscillator& oscillator, double h_s);

/// The paper's closed form for implicit Euler without damping: zeta = delta / sqrt(4 pi^2 + delta^2) with the
/// logarithmic decrement delta = pi ln(1 + omega^2 h^2) / angle(1 + i omega h). Source: Dubied et al. 2022, sec. IV-B.
double implicit_euler_numerical_damping(double omega_rad_s, double h_s);

/// Largest Lambda [1/s] under which implicit Euler does not grow: h omega^2 + 2 zeta omega. The velocity force is the
/// paper's, of the velocity at the start of the step; with it
///   (x1, v1) = 1 / D ((1 + 2 zeta omega h, h (1 + h Lambda)), (-h omega^2, 1 + h Lambda)) (x0, v0),   D = 1 + h^2
///   omega^2 + 2 zeta omega h,
/// whose conjugate roots have the squared modulus det = (1 + h Lambda) / D. With the velocity at the end, as in the
/// paper's stability analysis, det = 1 / (D - h Lambda): the same bound.
double implicit_euler_critical_velocity_force(double omega_rad_s, double h_s, double damping_ratio = 0.0);

/// The same bound for any integrator [1/s]: the least Lambda above which the spectral radius passes 1, to a millionth
/// of omega. Infinite where none up to a thousand times omega + 1/h does; an implicit scheme damps what grows too fast
/// for its step.
double critical_velocity_force(const TimeScheme& scheme, double omega_rad_s, double h_s, double damping_ratio = 0.0);

}  // namespace myo::dynamics
