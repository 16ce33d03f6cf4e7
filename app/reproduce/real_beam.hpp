#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "base/result.hpp"
#include "inverse/damped_cosine.hpp"
#include "reproduce/reproduction.hpp"

namespace myo::reproduce {

/// A recorded release of the real beam: markers Top, Left, Right in the frame of the beam, as displacements from the
/// held pose.
struct BeamTrial {
    std::string name;
    double tip_force_N = 0.0;                      // of the weight, as in the published scripts
    Eigen::VectorXd time_s;                        // 0 at the release
    std::vector<Eigen::Matrix3Xd> displacement_m;  // per marker, 3 x T
    Eigen::Matrix3d steady_m;                      // columns Top, Left, Right: mean of the last fifth
    double frame_rms_m = 0.0;  // residual of the rigid fit of the held pose to the nominal positions
};

/// Releases in the data folder: two without weight, two with 101 g. Missing files are skipped.
///
/// Errors: a damaged file, markers missing, no start found.
Result<std::vector<BeamTrial>> read_beam_trials(const ReproduceSettings& settings);

/// Damped vibration fitted to the Left marker along z, from the first turning point (0.065 s) to 1.5 s after the
/// release; not ok with fewer than eight visible samples.
inverse::DampedCosine measured_vibration(const BeamTrial& trial);

}  // namespace myo::reproduce
