#pragma once

namespace myo::model {

/// Value and derivatives of a smooth one-sided square.
struct OneSided {
    double value = 0.0;   // [m2]
    double slope = 0.0;   // [m]
    double second = 0.0;  // 0 to 1
};

/// Half the square of the positive part of t, whose second derivative rises linearly from 0 at t = 0 to 1 at t =
/// onset: twice continuously differentiable. Beyond the onset the slope is t - onset / 2, without end.
///
/// @param onset  positive [m]
inline OneSided one_sided(double t, double onset) {
    if (t <= 0.0) return {};
    if (t < onset) return {t * t * t / (6.0 * onset), 0.5 * t * t / onset, t / onset};
    const double beyond = t - 0.5 * onset;
    return {0.5 * beyond * beyond + onset * onset / 24.0, beyond, 1.0};
}

}  // namespace myo::model
