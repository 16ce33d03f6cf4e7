#pragma once

#include <cmath>

namespace myo::material {

/// Softening by the largest past strain, as in filled rubbers (Mullins effect). The elastic stress of a point is that
/// of the virgin material times
///   1 - d (1 - exp(-W / W0)), where W is the largest isochoric energy density of the virgin material that the point
///   has reached.
/// Source: Ogden & Roxburgh 1999; Simo 1987 (damage by the largest energy).
struct StressSoftening {
    double damage_max = 0.0;         // d, 0 <= d < 1
    double energy_scale_J_m3 = 1.0;  // W0 > 0

    bool operator==(const StressSoftening&) const = default;

    /// Factor of the elastic stress for the largest energy density W [J/m3].
    double factor(double peak_energy_J_m3) const {
        return 1.0 + damage_max * std::expm1(-peak_energy_J_m3 / energy_scale_J_m3);
    }
    /// Derivative of factor() with respect to W [m3/J].
    double slope(double peak_energy_J_m3) const {
        return -damage_max / energy_scale_J_m3 * std::exp(-peak_energy_J_m3 / energy_scale_J_m3);
    }
};

}  // namespace myo::material
