#pragma once

#include <Eigen/Core>

#include "dynamics/natural_modes.hpp"

namespace myo::dynamics {

/// Damping ratio of a small vibration under Kelvin-Voigt damping: factor damping_s omega / 2.
///
/// Viscous stresses are deviatoric. The factor is the deviatoric share of the strain energy of the mode: 1 in shear and
/// torsion, less where the volume or the width of a plate resists.
constexpr double damping_ratio(double factor, double damping_s, double omega_rad_s) {
    return 0.5 * factor * damping_s * omega_rad_s;
}

/// Damping factor of a mode about the equilibrium x (3 x n): work of the viscous forces of the model on the mode, for a
/// mode of any shape. Creep is not included.
double damping_factor(const model::Model& model, const Eigen::Matrix3Xd& x, const NaturalMode& mode);

/// Damping factor of slender bodies in stretching and bending, for use when no mode has been computed.
constexpr double slender_damping_factor(double poissons_ratio) { return 2.0 / 3.0 * (1.0 + poissons_ratio); }

}  // namespace myo::dynamics
