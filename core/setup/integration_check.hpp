#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dynamics/integrator.hpp"
#include "model/model.hpp"

namespace myo::setup {

/// What the time step makes of the body's slowest vibration about its rest shape, known before a run.
struct IntegrationCheck {
    double h_s = 0.0;
    double frequency_Hz = 0.0;             // of the first mode, undamped; 0: not found, and nothing else is
    double damping_factor = 0.0;           // of the material in this mode, see damping_ratio()
    double damping_ratio = 0.0;            // of the material, in this mode
    double numerical_damping_ratio = 0.0;  // of the scheme alone
    std::optional<double> critical_velocity_force_1_s;  // asked for where the model has a positive velocity force
    bool of_one_mode = false;  // the latter is the single vibration's, as the structure's was not found
    std::vector<std::string>
        warnings;  // one sentence each: a run that will grow, a scheme that damps more than the material
};

IntegrationCheck check_integration(const model::Model& model, const dynamics::TimeScheme& scheme, double h_s);

}  // namespace myo::setup
