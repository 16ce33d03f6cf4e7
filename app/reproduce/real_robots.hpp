#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "base/result.hpp"
#include "reproduce/reproduction.hpp"

namespace myo::reproduce {

/// Recorded motion of a robot's tracked point, as displacement from its position before the onset of pressure.
struct RobotTrial {
    std::string name;                        // of the file
    double pressure_mbar = 0.0;              // from the file name; 0 if it has none
    bool stepped = false;                    // a step trial (C3D), vented at its end; otherwise of the pressure sweep
    Eigen::VectorXd time_s;                  // 0 at the onset
    Eigen::Matrix3Xd tip_m;                  // 3 x T, frame of the robot
    std::vector<Eigen::Matrix3Xd> marker_m;  // the same for each moving marker
    double noise_m = 0.0;                    // of the tracked point, 1 sigma per coordinate
    double frame_rms_m = 0.0;                // residual of the rigid fit of the rest markers to their nominal positions
};

/// Mean displacement between two times [m], 3 x points: tracked point, then markers; NaN without samples.
Eigen::Matrix3Xd mean_between(const RobotTrial& trial, double from_s, double until_s);

/// Bending direction about z [rad] of the tracked point, measured from x, or from -x with bends_to = -1; the mean
/// direction of several poses (3 x points).
double bending_direction(const std::vector<Eigen::Matrix3Xd>& poses_m, double bends_to = -1.0);

/// All `<pressure>mbar.csv` of the arm's pressure sweep, by ascending pressure; empty if there are none.
///
/// Errors: a damaged file, markers missing, no onset found.
Result<std::vector<RobotTrial>> read_arm_sweep(const ReproduceSettings& settings);

/// Pressure steps of the arm, `*<pressure>mbar*.c3d`, by name. Errors: as above.
Result<std::vector<RobotTrial>> read_arm_steps(const ReproduceSettings& settings);

/// Recording of the fish tail; none or one. Errors: as above.
Result<std::vector<RobotTrial>> read_fish(const ReproduceSettings& settings);

}  // namespace myo::reproduce
