#pragma once

#include <memory>
#include <string>
#include <vector>

#include "reproduce/pressure_map.hpp"
#include "reproduce/real_robots.hpp"
#include "reproduce/tip_response.hpp"

namespace myo::reproduce {

/// When a pose is compared: 0.7 s after the onset, or at the end of the record.
enum class Instant { after_0_7_s, end };
inline constexpr Instant both_instants[] = {Instant::after_0_7_s, Instant::end};
std::string to_string(Instant instant);

/// The pose of a trial then, 3 x points [m]: mean of 0.04 s around, or of the last 0.1 s.
Eigen::Matrix3Xd pose_at(const RobotTrial& trial, Instant instant);

/// A way to model the arm. As published, x and z of the tip centre are fitted and the map is a plain polynomial.
/// Otherwise the arm bends in a plane through its axis whose direction is the recordings', and the map begins at rest.
struct ArmVariant {
    std::string name;
    MuscleBodyOptions body;
    MuscleConfiguration configuration;
    bool fit_markers = false;  // x, y, z of the tip markers instead of the tip centre
};

/// A variant fitted to the poses of all trials at an instant, each by itself.
struct FittedArm {
    ArmVariant variant;
    std::shared_ptr<const TipResponse> response;
    std::vector<Eigen::Matrix3Xd> measured_m;  // per trial, 3 x points
    std::vector<double> pressures_mbar;
    std::vector<PoseFit> fits;
    std::vector<double> marker_rms_m;  // over x, y, z of the tip markers

    int simulations() const;
};
/// Errors: geometry, a pose that was not reached; "stopped".
Result<FittedArm> fit_arm(const std::shared_ptr<const TipResponse>& response, const ArmVariant& variant,
                          const std::vector<RobotTrial>& trials, Instant instant, const Progress& progress);

/// What a variant says of a pressure when it knows some of the trials only.
struct ArmPrediction {
    Eigen::VectorXd signals;
    Eigen::Vector3d tip_m = Eigen::Vector3d::Constant(std::nan(""));  // NaN: no equilibrium at these signals
};
ArmPrediction predict_arm(const FittedArm& arm, const std::vector<std::size_t>& known, double pressure_mbar);

/// The measure: |predicted - measured| / |measured| of the tip centre's displacement.
double relative_error(const Eigen::Vector3d& predicted_m, const Eigen::Vector3d& measured_m);

}  // namespace myo::reproduce
