#pragma once

namespace myo::material {

/// Small-strain moduli [Pa].
struct Moduli {
    double mu = 0.0;     // shear modulus
    double kappa = 0.0;  // bulk modulus

    bool operator==(const Moduli&) const = default;
};

/// mu = E / (2 (1 + nu)), kappa = E / (3 (1 - 2 nu)).
/// @param youngs_modulus  [Pa]
/// @param poissons_ratio  in (-1, 0.5)
inline Moduli moduli_from_young(double youngs_modulus, double poissons_ratio) {
    return {youngs_modulus / (2.0 * (1.0 + poissons_ratio)), youngs_modulus / (3.0 * (1.0 - 2.0 * poissons_ratio))};
}

/// Alternative pair of elastic constants.
struct YoungPoisson {
    double youngs_modulus_Pa = 0.0;
    double poissons_ratio = 0.0;
};

/// Inverse of moduli_from_young(): E = 9 kappa mu / (3 kappa + mu), nu = (3 kappa - 2 mu) / (2 (3 kappa + mu)).
/// Moduli must not both vanish.
inline YoungPoisson young_from_moduli(const Moduli& m) {
    const double sum = 3.0 * m.kappa + m.mu;
    return {9.0 * m.kappa * m.mu / sum, (3.0 * m.kappa - 2.0 * m.mu) / (2.0 * sum)};
}

}  // namespace myo::material
