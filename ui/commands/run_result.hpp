#pragma once

#include <Eigen/Core>

#include <memory>
#include <string>
#include <vector>

#include "commands/check_view.hpp"

namespace myo::ui::commands {

/// One simulated trial. Frames for drawing may be coarser in time than the measurement; markers are not.
struct SimulatedTrial {
    std::string name;                       // name of the SceneTrial
    Eigen::VectorXd frame_time_s;           // F times [s], ascending
    std::vector<Eigen::Matrix3Xd> frames;   // F node positions, each 3 x n [m]
    std::vector<Eigen::Matrix3Xd> markers;  // per marker of the scene, 3 x T [m] at the trial's sample times
    std::vector<double> marker_rms_m;       // per marker; NaN without measurement
    double rms_m = 0.0;                     // over all markers; NaN without measurement
    double vibration_Hz = 0.0;              // frequency of the vibration that moves the markers most; 0: none found
};

/// Result of a simulation of all trials.
struct RunResult {
    std::vector<SimulatedTrial> trials;  // in the scene's order
    double rms_m = 0.0;                  // over all measured coordinates of all trials; NaN without any
    double seconds = 0.0;                // wall time
    double steps = 0.0;                  // time steps of all trials together
    std::string problem;                 // what went wrong; empty: nothing
    std::vector<std::string> warnings;   // about the time step
    double time_step_s = 0.0;            // shortest step, if the program chose it; otherwise 0
    CheckRows checks;                    // before and after the run
    std::shared_ptr<const void> source;  // data for its fields, owned by the backend; may be null
};

}  // namespace myo::ui::commands
