#pragma once

#include <string>
#include <vector>

#include "inverse/marker_target.hpp"
#include "prediction/prediction.hpp"
#include "sensitivity/gradient_check.hpp"

namespace myo::calibration {

/// The run of a gradient check; see gradcheck().
struct CheckedRun {
    const setup::Setup& setup;
    std::size_t trial = 0;
    prediction::ParameterValues values;   // at which it runs
    double end_s = 0.0;                   // of the run [s]
    Eigen::Matrix3Xd initial_velocities;  // 3 x n [m/s]
    const inverse::MarkerTarget& target;
};

/// Rows of a gradient check, and numbers that have none.
struct DeclaredGradients {
    std::vector<sensitivity::GradientCheckRow> rows;
    std::vector<std::string> left_out;  // name and reason, for people
    dynamics::RunStatus status = dynamics::RunStatus::complete;
    std::string message;
};

/// Derivatives of the loss, the mean square distance of the markers, by the numbers of the declared effects and by
/// modulus and damping of the parts: from the tangent of the run, as fits use it, against central differences of
/// fourth order. Four runs per number.
///
/// A number has no row if it changes only what is seen, if it stands at a bound, or if fits take its derivative from
/// differences of runs.
DeclaredGradients declared_gradients(const CheckedRun& run, int threads, const Progress& progress = {});

}  // namespace myo::calibration
