#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

#include "inverse/actuation_signals.hpp"
#include "inverse/least_squares.hpp"
#include "reproduce/muscle_body.hpp"

namespace myo::reproduce {

/// How signals act on muscles: a = 1 + factor (s - 1) per muscle.
struct MuscleConfiguration {
    std::string name;
    std::vector<inverse::SignalShare> muscles;  // signal and factor of each
    int signals = 1;                            // number of signals
    double lower = 0.2, upper = 5.0;            // bounds of the signals
};
// Configurations of the paper, and one with more freedom.
MuscleConfiguration one_muscle();    // AC1: a in [-5, 5]
MuscleConfiguration tied_muscles();  // AC2: a1 = 1 + 2 x, a2 = 1 - x with x in [0, 2]; the signal is a1
MuscleConfiguration free_muscles();  // two antagonists with a signal each

/// Observed points of a body in equilibrium under constant signals.
struct TipPose {
    bool ok = false;  // an equilibrium was found
    // Why there is no equilibrium; empty if there is one.
    std::string message;
    Eigen::Matrix3Xd displacement_m;  // 3 x points, from the equilibrium with all signals at 1; tracked point first
    std::vector<Eigen::Matrix3Xd> by_signal_m;  // derivative with respect to each signal
    Eigen::Matrix3Xd x;                         // nodes, 3 x n [m]

    Eigen::Vector3d tracked_m() const { return displacement_m.col(0); }
};

/// Equilibria of a body as a function of its signals, with exact derivatives. Const calls may run in parallel.
class TipResponse {
public:
    TipResponse(MuscleBody body, MuscleConfiguration configuration);

    const MuscleConfiguration& configuration() const { return configuration_; }
    const MuscleBody& body() const { return body_; }
    // Equilibrium with all signals at 1; not ok if there is none. The constructor computes it.
    const TipPose& rest() const { return rest_; }

    /// Equilibrium at these signals, with the derivatives of the points. Without an equilibrium the pose is not ok and
    /// says why.
    ///
    /// @param near  nodes of an equilibrium at similar signals, as initial guess; empty: the rest
    TipPose at(const Eigen::VectorXd& signals, const Eigen::Matrix3Xd& near = {}) const;

private:
    MuscleBody body_;
    MuscleConfiguration configuration_;
    TipPose rest_;
    Eigen::Matrix3Xd origin_m_;  // points at rest
};

/// Signals with which the observed points are closest to their goals.
struct PoseFit {
    Eigen::VectorXd signals;
    TipPose pose;
    // Equilibria that the fit has computed.
    int simulations = 0;
};
/// Least-squares fit of constant signals to point displacements, within the bounds of the configuration.
///
/// @param goal_m  3 x points; NaN: not compared
/// @param start   initial signals and equilibrium
/// Errors: not converged, no equilibrium; "stopped".
Result<PoseFit> fit_pose(const TipResponse& response, const Eigen::Matrix3Xd& goal_m, const PoseFit& start,
                         const Progress& progress);

/// The body in equilibrium with all signals at 1, as a start.
PoseFit unmoved(const TipResponse& response);

}  // namespace myo::reproduce
