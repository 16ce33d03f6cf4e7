#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "base/result.hpp"
#include "inverse/damped_cosine.hpp"
#include "reproduce/reproduction.hpp"

namespace myo::reproduce {

/// A recorded release of the real beam: markers Top, Left, Right in the beam's frame, as displacements from where they
/// were held.
struct BeamTrial {
    std::string name;
    double tip_force_N = 0.0;                      // of the weight, as the published scripts have it
    Eigen::VectorXd time_s;                        // 0 at the release
    std::vector<Eigen::Matrix3Xd> displacement_m;  // per marker, 3 x T
    Eigen::Matrix3d steady_m;                      // columns Top, Left, Right: mean of the last fifth
    double frame_rms_m = 0.0;                      // of the rigid fit of the held pose to the nominal positions
};

/// The releases in the folder of the data: two without a weight, two with 101 g. Files that are not there are left out.
/// Errors: a damaged file, markers missing, no start found.
Result<std::vector<BeamTrial>> read_beam_trials(const ReproduceSettings& settings);

/// The vibration of the Left marker along z from the first turning point on.
inverse::DampedCosine measured_vibration(const BeamTrial& trial);

}  // namespace myo::reproduce
