#pragma once

#include <memory>
#include <string>
#include <vector>

#include "reproduce/pressure_map.hpp"
#include "reproduce/real_robots.hpp"
#include "reproduce/tip_response.hpp"

namespace myo::reproduce {

/// Instant at which a pose is compared: 0.7 s after the onset, or the end of the record.
enum class Instant { after_0_7_s, end };
inline constexpr Instant both_instants[] = {Instant::after_0_7_s, Instant::end};
/// "0.7 s" or "end".
std::string to_string(Instant instant);

/// Pose of a trial at this instant, 3 x points [m], tracked point first: mean of 0.04 s around it, or of the last 0.1
/// s. NaN if nothing was seen then.
Eigen::Matrix3Xd pose_at(const RobotTrial& trial, Instant instant);

/// A model of the arm. As published, x and z of the tip centre are fitted and the map is a plain polynomial. Otherwise
/// the arm bends in a plane through its axis with the direction of the recordings, and the map starts at rest.
struct ArmVariant {
    std::string name;
    MuscleBodyOptions body;
    MuscleConfiguration configuration;
    bool fit_markers = false;  // fits x, y, z of the tip markers instead of the tip centre
};

/// A variant fitted to the poses of all trials at one instant, each trial separately.
struct FittedArm {
    ArmVariant variant;
    std::shared_ptr<const TipResponse> response;  // equilibria of the body, shared by variants and threads
    std::vector<Eigen::Matrix3Xd> measured_m;     // per trial, 3 x points
    // Per trial, ascending.
    std::vector<double> pressures_mbar;
    // Per trial; signals and pose of the fitted equilibrium.
    std::vector<PoseFit> fits;
    std::vector<double> marker_rms_m;  // per trial, over x, y, z of the tip markers

    int simulations() const;  // of all fits
};
/// Fits constant signals to the pose of every trial, each from the result of the one before.
///
/// @param response  of the body and configuration of the variant
/// @param trials    by ascending pressure
///
/// Errors: no equilibrium at rest; a trial without samples at the instant; a pose that cannot be reached; "stopped" if
/// cancelled.
Result<FittedArm> fit_arm(const std::shared_ptr<const TipResponse>& response, const ArmVariant& variant,
                          const std::vector<RobotTrial>& trials, Instant instant, const Progress& progress);

/// Prediction for a pressure from a map through some of the trials.
struct ArmPrediction {
    Eigen::VectorXd signals;  // from the map, limited to the admissible range
    /// Displacement of the tip centre from rest [m], frame of the robot; NaN if there is no equilibrium at these
    /// signals.
    Eigen::Vector3d tip_m = Eigen::Vector3d::Constant(std::nan(""));
};
/// Predicts the tip at a pressure.
///
/// @param known  indices of the trials that define the map, ascending; not empty
ArmPrediction predict_arm(const FittedArm& arm, const std::vector<std::size_t>& known, double pressure_mbar);

/// Error measure |predicted - measured| / |measured| of the displacement of the tip centre.
double relative_error(const Eigen::Vector3d& predicted_m, const Eigen::Vector3d& measured_m);

}  // namespace myo::reproduce
