#pragma once

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <array>
#include <cmath>
#include <complex>

#include "dynamics/natural_modes.hpp"
#include "dynamics/simulate.hpp"
#include "support/beam.hpp"

namespace myo::test {

/// Time steps of the paper's clamped beam [s].
inline constexpr std::array paper_steps{0.0025, 0.005, 0.0075, 0.01, 0.0125, 0.015, 0.0175, 0.02};

/// Eigenvalues of the 2 x 2 matrix that a time step applies to a linear oscillator.
std::array<std::complex<double>, 2> step_eigenvalues(const Eigen::Matrix2cd& A);

/// First natural mode about the rest shape.
dynamics::NaturalMode first_mode(const model::Model& model);

/// Adds a force that bends the beam along z by one per cent of its length and ends at t = 0.
void hold_until_zero(model::Model& model, const BeamSpec& spec);

/// The soft beam of the experiments, wider so that the mode along z is separate; without gravity. held() returns it
/// bent until t = 0.
BeamSpec ringing_beam();
model::Model held(const BeamSpec& spec);

/// Modal coordinate q = shape' M u of each recorded state.
Eigen::VectorXd modal_coordinate(const model::Model& model, const dynamics::NaturalMode& mode,
                                 const dynamics::Trace& trace);

/// Frequency and damping of an oscillation.
struct Oscillation {
    double omega_damped = 0.0;   // [rad/s]
    double damping_ratio = 0.0;  // without unit
};

/// Frequency and damping of a series sampled every h [s], by least squares for q(n+1) = a q(n) + b q(n-1) (Prony's
/// method).
Oscillation fit_oscillation(const Eigen::VectorXd& q, double h);

/// Releases a beam that is held by its present forces, which must end at t = 0, and returns its first modal coordinate
/// at each of `steps` steps of h [s]. Empty if the run fails.
Eigen::VectorXd ring(const model::Model& model, const dynamics::NaturalMode& mode, const dynamics::TimeScheme& scheme,
                     double h, int steps);

}  // namespace myo::test
