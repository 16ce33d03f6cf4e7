#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "base/progress.hpp"
#include "statistics/correlates.hpp"

namespace myo::setup {
struct Setup;
}  // namespace myo::setup

namespace myo::diagnosis {

struct Diagnosis;

/// A distribution of force over the body times a course over time.
struct ForceMode {
    Eigen::Matrix3Xd pattern;     // 3 x n nodal forces; their lengths add up to 1
    Eigen::VectorXd amplitude_N;  // at the force's times
    double share = 0.0;           // of the square of the force, over body and time
    double place = 0.0;           // of its middle: 0 at the clamp, 1 at the far end
    Eigen::Vector3d centroid_m;   // rest shape, mesh frame
    Eigen::Vector3d direction;    // of the sum of the forces, length 1
    double aligned = 0.0;         // length of that sum: 1 where all forces point alike, 0 for a pure moment
    double steady = 0.0;          // share of the course's square that is its mean's
    std::string where;            // "at the free end, along +y"
    std::vector<statistics::Correlate> correlates;  // strongest first

    double rms_N() const;
    double peak_N() const;  // largest size
};

/// The force that would have to act, besides all that the best fit has, for one trial to move as it was measured.
struct MissingForce {
    std::string trial;
    Eigen::VectorXd time_s;          // knots; linear between them
    std::vector<ForceMode> modes;    // largest share first
    double before_over_noise = 0.0;  // rms of the residual
    double after_over_noise = 0.0;   // of a run with the force
    int runs = 0;                    // of the trial, the one with tangents included
    std::string failure;             // why there is none; empty when there is

    double removed() const;  // share of the residual's square
};

/// The smallest smooth force in the fit trial that the best fit leaves the largest residual in.
///
/// Body forces over the way from clamp to far end (force_fields) by Tikhonov's rule: least integral of f^2 + (25 ms
/// df/dt)^2 with which the residual is that of noise (Morozov's principle), or nearly as small as it gets. Linear in
/// the force about the mean state; the trial is then run with it, and the step repeated with what is left. Costs one
/// run with 18 tangents and up to nine plain ones. Source: Morozov 1984 (discrepancy principle); Hansen 1998, ch. 5
/// (Tikhonov regularisation).
MissingForce infer_missing_force(const setup::Setup& setup, const Diagnosis& diagnosis, const Progress& progress = {});

}  // namespace myo::diagnosis
