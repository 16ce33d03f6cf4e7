#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "inverse/actuation_signals.hpp"
#include "inverse/least_squares.hpp"
#include "reproduce/muscle_body.hpp"

namespace myo::reproduce {

/// How the signals of a configuration act on the muscles: a = 1 + factor (s - 1), per muscle.
struct MuscleConfiguration {
    std::string name;
    std::vector<inverse::SignalShare> muscles;
    int signals = 1;
    double lower = 0.2, upper = 5.0;  // of the signals
};
MuscleConfiguration one_muscle();    // AC1: a in [-5, 5]
MuscleConfiguration tied_muscles();  // AC2: a1 = 1 + 2 x, a2 = 1 - x with x in [0, 2]; the signal is a1
MuscleConfiguration free_muscles();  // two antagonists with a signal each

/// The observed points of a body at rest under constant signals.
struct TipPose {
    bool ok = false;
    std::string message;
    Eigen::Matrix3Xd displacement_m;  // 3 x points, from where they rest with all signals at 1; the tracked point first
    std::vector<Eigen::Matrix3Xd> by_signal_m;  // its derivative with respect to each signal
    Eigen::Matrix3Xd x;                         // the body, 3 x n [m]

    Eigen::Vector3d tracked_m() const { return displacement_m.col(0); }
};

/// Equilibria of a body over its signals, with exact derivatives.
class TipResponse {
public:
    TipResponse(MuscleBody body, MuscleConfiguration configuration);

    const MuscleConfiguration& configuration() const { return configuration_; }
    const MuscleBody& body() const { return body_; }
    const TipPose& rest() const { return rest_; }

    /// near: an equilibrium at signals not far away, where the search begins; empty: the rest.
    TipPose at(const Eigen::VectorXd& signals, const Eigen::Matrix3Xd& near = {}) const;

private:
    MuscleBody body_;
    MuscleConfiguration configuration_;
    TipPose rest_;
    Eigen::Matrix3Xd origin_m_;  // of the points
};

/// Signals that bring the points of a body nearest to where they shall be.
struct PoseFit {
    Eigen::VectorXd signals;
    TipPose pose;
    int simulations = 0;
};
/// @param goal_m  3 x points; NaN: anywhere
/// @param start   where the search begins
/// Error: it did not converge; no equilibrium was found.
Result<PoseFit> fit_pose(const TipResponse& response, const Eigen::Matrix3Xd& goal_m, const PoseFit& start,
                         const Progress& progress);

/// The body at rest with all signals at 1, to start from.
PoseFit unmoved(const TipResponse& response);

}  // namespace myo::reproduce
