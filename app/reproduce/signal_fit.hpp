#pragma once

#include <string>

#include "inverse/actuation_fit.hpp"
#include "reproduce/real_robots.hpp"
#include "reproduce/tip_response.hpp"

namespace myo::reproduce {

/// A model and control configuration with which a robot follows a recorded motion.
struct SignalVariant {
    std::string name;
    MuscleBodyOptions body;
    MuscleConfiguration configuration;
    double frequency_Hz = 20.0;  // of the knots
    int max_evaluations = 40;
};

/// Signals found, and the resulting motion of the tracked point.
struct SignalFit {
    // What was fitted, and how.
    SignalVariant variant;
    inverse::SoughtSignals sought;
    inverse::ActuationFit fit;
    std::vector<fibre::Signal> activation;            // per muscle
    Eigen::VectorXd times_s;                          // of the record, from its onset on
    Eigen::Matrix3Xd measured_m, simulated_m;         // 3 x T, frame of the robot
    Eigen::Vector3d rms_m = Eigen::Vector3d::Zero();  // per axis
    double largest_jump = 0.0;                        // of a muscle's activation from knot to knot
    double largest_rate_1_s = 0.0;                    // that jump times the knot frequency
    double range = 0.0;                               // of that muscle's activation
    int at_bounds = 0;                                // number of values at a bound
    double seconds = 0.0;                             // wall-clock time
};

/// Optimises signals at the control frequency, starting from those that hold each measured pose at rest.
///
/// As published: held from knot to knot, implicit Euler, x and z. Otherwise linear between knots, TR-BDF2, and x, y, z,
/// with bending in the plane of the recording's final pose. Smoothness, see ActuationProblem, is weighted with the
/// noise of the recording, at least 0.02 mm s.
/// Errors: geometry, a run that failed; "stopped".
Result<SignalFit> fit_signals(const ReproduceSettings& settings, const MuscleRobot& robot, const SignalVariant& variant,
                              const RobotTrial& trial, const Progress& progress);

/// Several variants in parallel on the threads of the settings; results in the order of the variants. Errors: the first
/// variant that failed, in their order.
Result<std::vector<SignalFit>> fit_all_signals(const ReproduceSettings& settings, const MuscleRobot& robot,
                                               const std::vector<SignalVariant>& variants, const RobotTrial& trial,
                                               const Progress& progress);

/// Errors and smoothness, one row per fit.
report::Table signal_table(const std::string& caption, const std::vector<SignalFit>& fits);

/// x, y, z of all fits with the measured ones, and the signals below, as SVG. The fits are of one recording.
std::string signal_figure(const std::string& title, const std::vector<SignalFit>& fits);

/// Numbers of signal_table() as JSON in SI units, with all signals.
report::Json signal_json(const std::vector<SignalFit>& fits);

}  // namespace myo::reproduce
