#pragma once

namespace myo {

/// Small-strain moduli [Pa].
struct Moduli {
    double mu = 0.0;
    double kappa = 0.0;
};

/// mu = E / (2 (1 + nu)), kappa = E / (3 (1 - 2 nu)). nu in (-1, 0.5).
inline Moduli moduli_from_young(double youngs_modulus, double poissons_ratio) {
    return {youngs_modulus / (2.0 * (1.0 + poissons_ratio)), youngs_modulus / (3.0 * (1.0 - 2.0 * poissons_ratio))};
}

/// Moduli of plane stress, E / (1 - nu^2) and nu E / (1 - nu^2), written in mu and kappa.
///
/// With nu = (3 kappa - 2 mu) / (2 (3 kappa + mu)): plane = 2 mu / (1 - nu) = 4 mu (3 kappa + mu) / (3 kappa + 4 mu),
/// coupling = nu plane = 2 mu (3 kappa - 2 mu) / (3 kappa + 4 mu).
struct PlaneStressModuli {
    double plane = 0.0;
    double coupling = 0.0;
};

inline PlaneStressModuli plane_stress_moduli(const Moduli& m) {
    const double denominator = 3.0 * m.kappa + 4.0 * m.mu;
    return {4.0 * m.mu * (3.0 * m.kappa + m.mu) / denominator, 2.0 * m.mu * (3.0 * m.kappa - 2.0 * m.mu) / denominator};
}

/// Directional derivative of plane_stress_moduli at m along d.
inline PlaneStressModuli plane_stress_moduli_tangent(const Moduli& m, const Moduli& d) {
    const double denominator = 3.0 * m.kappa + 4.0 * m.mu;
    const double d_denominator = 3.0 * d.kappa + 4.0 * d.mu;
    const PlaneStressModuli value = plane_stress_moduli(m);
    const double d_plane = 4.0 * d.mu * (3.0 * m.kappa + m.mu) + 4.0 * m.mu * (3.0 * d.kappa + d.mu);
    const double d_coupling = 2.0 * d.mu * (3.0 * m.kappa - 2.0 * m.mu) + 2.0 * m.mu * (3.0 * d.kappa - 2.0 * d.mu);
    return {(d_plane - value.plane * d_denominator) / denominator, (d_coupling - value.coupling * d_denominator) / denominator};
}

}  // namespace myo
