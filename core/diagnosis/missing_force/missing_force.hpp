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

/// Mode of a force: distribution over the body times course over time.
struct ForceMode {
    Eigen::Matrix3Xd pattern;     // 3 x n nodal forces; their magnitudes sum to 1
    Eigen::VectorXd amplitude_N;  // at MissingForce::time_s
    double share = 0.0;           // of the squared force, over body and time
    double place = 0.0;           // position of its centre along the body, 0 at the clamp, 1 at the far end
    Eigen::Vector3d centroid_m;   // rest shape, mesh frame
    Eigen::Vector3d direction;    // of the resultant, unit length
    double aligned = 0.0;         // magnitude of the resultant: 1 if all forces are parallel, 0 for a pure moment
    double steady = 0.0;          // share of the mean in the squares of the course
    std::string where;            // such as "at the free end, along +y"
    std::vector<statistics::Correlate> correlates;  // strongest first

    double rms_N() const;
    double peak_N() const;  // largest magnitude
};

/// Force that must act, in addition to those of the best fit, for one trial to move as measured.
struct MissingForce {
    std::string trial;
    Eigen::VectorXd time_s;          // knots; courses are linear between them
    std::vector<ForceMode> modes;    // largest share first
    double before_over_noise = 0.0;  // rms of the residual without the force [noise levels]
    double after_over_noise = 0.0;   // rms of the residual of a run with the force [noise levels]
    int runs = 0;                    // runs of the trial, the run with tangents included
    std::string failure;             // reason why no force was found; empty: found

    double removed() const;  // share of the squared residual
};

/// Smallest smooth force in the fit trial with the largest residual of the best fit.
///
/// Body forces between clamp and far end (force_fields) by Tikhonov regularisation: the smallest integral of
/// f^2 + (25 ms df/dt)^2 for which the residual is at the level of noise (Morozov's principle), or nearly as small as
/// possible.
/// The response to the force is linearised about the mean state; the trial is then run with the force, and the step is
/// repeated for the remaining residual. Costs one run with 18 tangents and up to nine without.
/// Errors: see MissingForce::failure.
/// Source: Morozov 1984 (discrepancy principle); Hansen 1998, ch. 5 (Tikhonov regularisation).
MissingForce infer_missing_force(const setup::Setup& setup, const Diagnosis& diagnosis, const Progress& progress = {});

}  // namespace myo::diagnosis
