#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dynamics/integrator.hpp"
#include "model/model.hpp"

namespace myo::setup {

/// A-priori check of a time step on the slowest vibration about the rest shape.
struct IntegrationCheck {
    double h_s = 0.0;                      // time step [s]
    double frequency_Hz = 0.0;             // first natural frequency, undamped; 0 = no mode found, other members unset
    double damping_factor = 0.0;           // material factor of this mode, see damping_ratio()
    double damping_ratio = 0.0;            // of the material in this mode [-]
    double numerical_damping_ratio = 0.0;  // of the scheme alone [-]
    /// Stability limit of the velocity force [1/s]; only if the model has a positive one.
    std::optional<double> critical_velocity_force_1_s;
    bool of_one_mode = false;  // the limit is that of the first mode, because the structure's did not converge
    /// One sentence each: a run that will grow, a scheme that damps more than the material.
    std::vector<std::string> warnings;
};

/// Checks whether a run with this step will grow or lose more energy to the scheme than to the material, by the linear
/// theory of the first vibration about the rest shape.
///
/// @param h_s  time step [s]
/// Errors: none; without modes frequency_Hz stays 0.
IntegrationCheck check_integration(const model::Model& model, const dynamics::TimeScheme& scheme, double h_s);

}  // namespace myo::setup
