#pragma once

#include <Eigen/Core>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "base/result.hpp"
#include "commands/run_result.hpp"

// Interface of a model that moves in real time while a person pulls it and moves its actuators.

namespace myo::ui::commands {

/// Patch of the body that the mouse holds.
struct LiveGrip {
    std::vector<int> nodes;                             // of the mesh
    Eigen::VectorXd shares;                             // per node, sum to 1
    Eigen::Matrix3Xd offsets_m;                         // of the nodes from the held point when it was taken, 3 x nodes
    Eigen::Vector3d place_m = Eigen::Vector3d::Zero();  // of the mouse, world frame

    bool operator==(const LiveGrip& other) const {
        return nodes == other.nodes && shares == other.shares && offsets_m == other.offsets_m &&
               place_m == other.place_m;
    }
};

/// What a person sets while the model moves, SI units.
struct LiveControls {
    double time_step_s = 0.01;
    bool own_step = false;            // otherwise the step is lengthened where real time requires it
    double damping_s = 0.0;           // Kelvin-Voigt time
    double velocity_force_1_s = 0.0;  // Lambda
    std::vector<double> levels;       // per actuator of the model; empty: as it begins
    double spring_N_m = 0.0;          // of the spring between mouse and body; 0: as the model proposes
    std::optional<LiveGrip> grip;     // empty: nothing is pulled

    bool operator==(const LiveControls&) const = default;
};

/// A muscle, chamber or tendon of a model that moves.
struct LiveActuator {
    std::string name;
    std::string quantity;                // "Activation", "Pressure", "Tension"
    std::string unit;                    // shown; empty: none
    double per_unit = 1.0;               // SI per shown unit
    double lowest = 0.0, highest = 1.0;  // SI
    double level = 0.0;                  // SI, at the beginning
};

/// State of the model after a step.
struct LiveFrame {
    std::shared_ptr<const RunResult> run;     // one frame of the shown trial
    std::vector<Eigen::Vector3d> markers_m;   // of the scene, where they are now
    double time_s = 0.0;                      // since the beginning
    double step_s = 0.0;                      // length of the step
    double force_N = 0.0;                     // with which the mouse pulls
    Eigen::Vector3d pulled_m{0.0, 0.0, 0.0};  // where the held patch is, without its offsets; unset without a grip
};

/// A model that moves. Used by one thread.
class LiveModel {
public:
    virtual ~LiveModel() = default;
    /// Muscles, chambers and tendons that can be moved, in the order of LiveControls::levels.
    virtual std::vector<LiveActuator> actuators() const = 0;
    /// Stiffness of the spring with which a hand pulls this body without tearing it [N/m].
    virtual double spring_N_m() const = 0;
    /// Takes one step.
    ///
    /// Errors: the step has no solution; cancelled. The model stays as before.
    virtual Result<LiveFrame> step(const LiveControls& controls, const Progress& progress) = 0;
};

}  // namespace myo::ui::commands
