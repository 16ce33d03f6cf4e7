#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "base/result.hpp"
#include "dynamics/simulate.hpp"
#include "dynamics/stepper.hpp"

namespace myo::dynamics {

/// A patch of the body in a hand, which pulls it by springs. A single node would be torn out of the body before the
/// body follows.
struct Grip {
    std::vector<int> nodes;      // of the patch
    Eigen::VectorXd shares;      // per node, sum to 1
    Eigen::Matrix3Xd places_m;   // where the hand has them, 3 x nodes, world frame
    double stiffness_N_m = 0.0;  // of all springs together, >= 0
};

/// What a person changes while the body moves.
struct LiveControls {
    double h_s = 0.01;                // length of the next step, > 0
    double damping_s = 0.0;           // Kelvin-Voigt time
    double velocity_force_1_s = 0.0;  // Lambda
    std::vector<double> activation;   // per fibre group
    std::vector<double> commands;     // per force element with a command, in their order [unit of the command]
    std::optional<Grip> grip;         // empty: nothing is pulled
};
/// The controls of a model at an instant [s], right of a jump.
LiveControls controls_of(const model::Model& model, double time_s);

/// A run without an end, of which a person changes signals and loads between two steps.
///
/// The signals of muscles, chambers and tendons are constant between two steps, as the controls say; all other loads
/// act at their times. With unchanged controls the motion is that of simulate() with the same step. A step that fails,
/// or gains energy that nothing supplied, is halved once or twice.
///
/// Not thread-safe.
class LiveRun {
public:
    /// @param options  start, time scheme, solver; its step and end are not used
    /// Errors: no start state; cancelled.
    static Result<std::unique_ptr<LiveRun>> begin(model::Model model, const SimulationOptions& options,
                                                  const LiveControls& controls, const Progress& progress);

    /// Takes one step, ended early by a jump of the loads.
    ///
    /// Errors: no solution for the step; cancelled. The state stays that before the step.
    Result<void> advance(const LiveControls& controls, const Progress& progress);

    double time_s() const { return point_.time_s; }
    const Kinematics& state() const { return point_.state; }
    const model::Model& model() const { return model_; }
    /// Force of the hand on the body [N], world frame; zero if nothing is pulled.
    Eigen::Vector3d grip_force() const;

private:
    LiveRun(model::Model model, const SimulationOptions& options);

    void apply(const LiveControls& controls);
    void renew_solver();
    Result<void> step_to(double end_s, bool jump_at_end, const Progress& progress);
    void accept(SolvedStep& step);

    model::Model model_;  // with the signals of the controls; the grip is its last force element
    SimulationOptions options_;
    std::size_t own_elements_ = 0;  // force elements of the model itself
    LiveControls controls_;
    std::vector<double> jumps_;  // of the loads [s]
    std::unique_ptr<StageSolver> solver_;
    std::unique_ptr<Stepper> stepper_;
    RunPoint point_;
    bool euler_next_ = false;  // see needs_euler()
};

}  // namespace myo::dynamics
