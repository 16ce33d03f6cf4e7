#pragma once

#include <Eigen/Core>

#include <memory>
#include <string>
#include <vector>

#include "commands/check_view.hpp"

namespace myo::ui::commands {

/// One simulated trial; frames may be coarser than the measurement.
struct SimulatedTrial {
    std::string name;                       // of the SceneTrial
    Eigen::VectorXd frame_time_s;           // F
    std::vector<Eigen::Matrix3Xd> frames;   // F node positions, 3 x n [m]
    std::vector<Eigen::Matrix3Xd> markers;  // per marker of the scene, 3 x T at the trial's time_s [m]
    std::vector<double> marker_rms_m;       // per marker, NaN without measurement
    double rms_m = 0.0;                     // NaN without measurement
    double vibration_Hz = 0.0;              // that moves the markers most; 0: none is seen
};

struct RunResult {
    std::vector<SimulatedTrial> trials;  // of the scene, in its order
    double rms_m = 0.0;                  // over all measured coordinates of all trials; NaN without any
    double seconds = 0.0;                // wall time
    double steps = 0.0;                  // in time, of all trials together
    std::string problem;                 // what went wrong on the way; empty = nothing
    std::vector<std::string> warnings;   // of its time step
    double time_step_s = 0.0;            // the shortest of its trials, where the program chose it; else 0
    CheckRows checks;                    // before and after it
    std::shared_ptr<const void> source;  // the backend's own: what its fields are made from; may be null
};

}  // namespace myo::ui::commands
