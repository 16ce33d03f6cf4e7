#pragma once

#include <Eigen/Core>

#include "dynamics/natural_modes.hpp"

namespace myo::dynamics {

/// What a Kelvin-Voigt time makes of a small vibration: the damping ratio factor damping_s omega / 2. Viscous stresses
/// are deviatoric, so that the factor is that of its strains: 1 in shear and torsion, less where volume or a wide
/// plate's breadth resists.
constexpr double damping_ratio(double factor, double damping_s, double omega_rad_s) {
    return 0.5 * factor * damping_s * omega_rad_s;
}

/// The factor of a mode of the model about the equilibrium x: what its own viscous forces take from it, whatever its
/// shape.
double damping_factor(const model::Model& model, const Eigen::Matrix3Xd& x, const NaturalMode& mode);

/// The factor of slender bodies that stretch and bend, where no mode is known.
constexpr double slender_damping_factor(double poissons_ratio) { return 2.0 / 3.0 * (1.0 + poissons_ratio); }

}  // namespace myo::dynamics
