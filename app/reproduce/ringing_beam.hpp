#pragma once

#include <Eigen/Core>

#include "base/progress.hpp"
#include "base/result.hpp"
#include "dynamics/integrator.hpp"
#include "dynamics/natural_modes.hpp"
#include "inverse/damped_cosine.hpp"
#include "reproduce/paper_beam.hpp"

namespace myo::reproduce {

/// Time steps that the paper compares [s].
inline constexpr double paper_steps_s[] = {0.0025, 0.005, 0.0075, 0.010, 0.0125, 0.015, 0.0175, 0.020};
inline constexpr std::size_t paper_step_count = std::size(paper_steps_s);

/// A beam with its equilibrium and its first vertical mode there.
struct RingingBeam {
    PaperBeam beam;
    model::Model model;
    Eigen::Matrix3Xd equilibrium;  // 3 x n [m]
    // First vertical bending mode about the equilibrium.
    dynamics::NaturalMode mode;
};
/// Errors: no equilibrium or no mode was found.
Result<RingingBeam> ringing_beam(const PaperBeam& beam);

/// Release from the straight shape at rest, like the real beam.
struct RingingRun {
    dynamics::TimeScheme scheme;
    double h_s = 0.01;                // time step
    double velocity_force_1_s = 0.0;  // Lambda
    // Kelvin-Voigt time.
    double damping_s = 0.0;
    double end_s = 1.2;
};
/// Motion after a release.
struct RungBeam {
    inverse::DampedCosine vibration;  // of the first modal coordinate
    // Times of all steps [s], from the release on.
    Eigen::VectorXd times_s;
    Eigen::VectorXd left_dz_m;  // of the paper's point Left
};
/// Simulates a release with the model of `beam`, its velocity force and damping replaced by those of `run`.
///
/// Errors (place: the time step): the run did not complete, or nothing vibrates.
Result<RungBeam> ring(const RingingBeam& beam, const RingingRun& run, const Progress& progress);

}  // namespace myo::reproduce
