#include "commands/settings.hpp"

#include <algorithm>

namespace myo::ui::commands {

Settings within_limits(Settings s) {
    // NaN passes through clamp unchanged; number fields reject it before.
    const auto limit = [](double& value, const Limits& limits) {
        value = std::clamp(value, limits.lowest, limits.highest);
    };
    limit(s.youngs_modulus_Pa, youngs_modulus_limits);
    limit(s.poissons_ratio, poissons_ratio_limits);
    limit(s.density_kg_m3, density_limits);
    limit(s.damping_s, damping_limits);
    limit(s.time_step_s, time_step_limits);
    limit(s.velocity_force_1_s, velocity_force_limits);
    limit(s.spectral_radius, spectral_radius_limits);
    for (Muscle& muscle : s.muscles) {
        limit(muscle.stiffness_Pa, muscle_stiffness_limits);
        limit(muscle.ratio, muscle_ratio_limits);
    }
    return s;
}

}  // namespace myo::ui::commands
