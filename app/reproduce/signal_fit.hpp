#pragma once

#include <string>

#include "inverse/actuation_fit.hpp"
#include "reproduce/real_robots.hpp"
#include "reproduce/tip_response.hpp"

namespace myo::reproduce {

/// A way to make a robot follow a recorded motion.
struct SignalVariant {
    std::string name;
    MuscleBodyOptions body;
    MuscleConfiguration configuration;
    double frequency_Hz = 20.0;
    int max_evaluations = 40;
};

/// The signals found, and where the tracked point goes with them.
struct SignalFit {
    SignalVariant variant;
    inverse::SoughtSignals sought;
    inverse::ActuationFit fit;
    std::vector<fibre::Signal> activation;            // of the muscles
    Eigen::VectorXd times_s;                          // of the record, from its onset on
    Eigen::Matrix3Xd measured_m, simulated_m;         // 3 x T
    Eigen::Vector3d rms_m = Eigen::Vector3d::Zero();  // per axis
    double largest_jump = 0.0;                        // of a muscle's activation from knot to knot
    double largest_rate_1_s = 0.0;
    double range = 0.0;  // of that muscle's activation
    int at_bounds = 0;   // values that ended there
    double seconds = 0.0;
};

/// Looks for signals at the control frequency, from those that hold each measured pose at rest.
///
/// As published: held from knot to knot, implicit Euler, x and z. Otherwise linear from knot to knot, TR-BDF2, and x,
/// y, z, where the robot bends in the plane of the recording's end. Smoothness: see ActuationProblem; weighted with the
/// noise of the recording, at least 0.02 mm s. Errors: geometry, a run that failed; "stopped".
Result<SignalFit> fit_signals(const ReproduceSettings& settings, const MuscleRobot& robot, const SignalVariant& variant,
                              const RobotTrial& trial, const Progress& progress);

/// Several, side by side on the threads of the settings.
Result<std::vector<SignalFit>> fit_all_signals(const ReproduceSettings& settings, const MuscleRobot& robot,
                                               const std::vector<SignalVariant>& variants, const RobotTrial& trial,
                                               const Progress& progress);

/// Rows of errors and smoothness, one per fit.
report::Table signal_table(const std::string& caption, const std::vector<SignalFit>& fits);

/// x, y, z of all fits over the measured ones, and the signals below them.
std::string signal_figure(const std::string& title, const std::vector<SignalFit>& fits);

report::Json signal_json(const std::vector<SignalFit>& fits);

}  // namespace myo::reproduce
