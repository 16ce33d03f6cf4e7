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

}  // namespace myo
