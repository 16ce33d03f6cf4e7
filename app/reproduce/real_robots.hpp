#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "base/result.hpp"
#include "reproduce/reproduction.hpp"

namespace myo::reproduce {

/// A recorded motion of a robot's tracked point, as displacement from where it was before the pressure came on.
struct RobotTrial {
    std::string name;                        // of the file
    double pressure_mbar = 0.0;              // by that name; 0 where it has none
    bool stepped = false;                    // a step trial (C3D), vented at its end; otherwise of the pressure sweep
    Eigen::VectorXd time_s;                  // 0 at the onset
    Eigen::Matrix3Xd tip_m;                  // 3 x T, robot's frame
    std::vector<Eigen::Matrix3Xd> marker_m;  // the same of the markers that moved
    double noise_m = 0.0;                    // 1 sigma per coordinate
    double frame_rms_m = 0.0;                // of the rigid fit of the rest markers to their nominal positions
};

/// Mean displacement between two times [m], 3 x points: the tracked point, then the markers; NaN where nothing was
/// recorded.
Eigen::Matrix3Xd mean_between(const RobotTrial& trial, double from_s, double until_s);

/// The direction about z in which the tracked point moved [rad], from x or, with bends_to = -1, from -x; over several
/// poses (3 x points) the mean of their directions.
double bending_direction(const std::vector<Eigen::Matrix3Xd>& poses_m, double bends_to = -1.0);

/// All `<pressure>mbar.csv` of the arm's pressure sweep, by pressure. Empty when there are none.
/// Errors: a damaged file, markers missing, no onset found.
Result<std::vector<RobotTrial>> read_arm_sweep(const ReproduceSettings& settings);

/// The arm's pressure steps, `*<pressure>mbar*.c3d`, by name.
Result<std::vector<RobotTrial>> read_arm_steps(const ReproduceSettings& settings);

/// The recording of the fish tail; none or one.
Result<std::vector<RobotTrial>> read_fish(const ReproduceSettings& settings);

}  // namespace myo::reproduce
