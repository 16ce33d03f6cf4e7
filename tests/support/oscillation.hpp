#pragma once

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <cmath>
#include <complex>

#include "dynamics/natural_modes.hpp"
#include "dynamics/simulate.hpp"
#include "support/beam.hpp"

namespace myo::test {

/// First mode about the rest shape.
NaturalMode first_mode(const Model& model);

/// Bends the beam along z by a hundredth of its length until t = 0.
void hold_until_zero(Model& model, const BeamSpec& spec);

/// The soft beam of the experiments but for its width, which sets the mode along z apart; held, without gravity.
BeamSpec ringing_beam();
Model held(const BeamSpec& spec);

/// Modal coordinate shape' M u of every recorded state.
Eigen::VectorXd modal_coordinate(const Model& model, const NaturalMode& mode, const Trace& trace);

struct Oscillation {
    double omega_damped = 0.0;   // [rad/s]
    double damping_ratio = 0.0;
};

/// Frequency and damping of a series sampled every h: least squares for q(n+1) = a q(n) + b q(n-1) (Prony's method).
Oscillation fit_oscillation(const Eigen::VectorXd& q, double h);

/// Lets go of a beam held by its present forces, which must end at t = 0, and returns its first modal coordinate.
Eigen::VectorXd ring(const Model& model, const NaturalMode& mode, const TimeScheme& scheme, double h, int steps);

}  // namespace myo::test
