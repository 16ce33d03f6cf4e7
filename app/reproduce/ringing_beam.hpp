#pragma once

#include <Eigen/Core>

#include "base/progress.hpp"
#include "base/result.hpp"
#include "dynamics/integrator.hpp"
#include "dynamics/natural_modes.hpp"
#include "inverse/damped_cosine.hpp"
#include "reproduce/paper_beam.hpp"

namespace myo::reproduce {

/// The time steps of the paper's studies [s].
inline constexpr double paper_steps_s[] = {0.0025, 0.005, 0.0075, 0.010, 0.0125, 0.015, 0.0175, 0.020};

/// A beam with its rest under its loads and its first mode there.
struct RingingBeam {
    PaperBeam beam;
    model::Model model;
    Eigen::Matrix3Xd equilibrium;  // 3 x n [m]
    dynamics::NaturalMode mode;
};
/// Error: no equilibrium or no mode was found.
Result<RingingBeam> ringing_beam(const PaperBeam& beam);

/// How it is let go: straight, at rest, as the real one.
struct RingingRun {
    dynamics::TimeScheme scheme;
    double h_s = 0.01;
    double velocity_force_1_s = 0.0;
    double damping_s = 0.0;
    double end_s = 1.2;
};
struct RungBeam {
    inverse::DampedCosine vibration;  // of the first mode's coordinate
    Eigen::VectorXd times_s;
    Eigen::VectorXd left_dz_m;  // of the paper's point Left
};
/// Error: the run did not complete, or nothing swings.
Result<RungBeam> ring(const RingingBeam& beam, const RingingRun& run, const Progress& progress);

}  // namespace myo::reproduce
