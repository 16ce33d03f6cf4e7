#pragma once

#include <algorithm>
#include <vector>

namespace myo::measurement {

/// Weights of position and velocity on the cubic Hermite curve of one step interval:
/// x(t) = x0 x_k + v0 v_k + x1 x_{k+1} + v1 v_{k+1}, with k = step.
struct HermiteWeights {
    std::size_t step = 0;                               // interval [step, step + 1]
    double x0 = 1.0, v0 = 0.0, x1 = 0.0, v1 = 0.0;      // of the position; v0, v1 [s]
    double dx0 = 0.0, dv0 = 0.0, dx1 = 0.0, dv1 = 0.0;  // of the velocity; dx0, dx1 [1/s]

    /// The velocity weights in the place of the position weights.
    HermiteWeights rate() const { return {step, dx0, dv0, dx1, dv1}; }
};

/// Weights at time t.
///
/// Before the first step the body rests at its first position; after the last one it stays at its last position.
/// @param times  of the steps [s], ascending, not empty
inline HermiteWeights hermite_weights(const std::vector<double>& times, double t) {
    HermiteWeights w;
    if (t <= times.front() || times.size() == 1) return w;  // weight 1 on the first position
    if (t >= times.back()) {
        w.step = times.size() - 2;
        w.x0 = 0.0;
        w.x1 = 1.0;
        w.dv1 = t > times.back() ? 0.0 : 1.0;  // velocity zero after the end
        return w;
    }
    w.step = static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), t) - times.begin()) - 1;
    const double h = times[w.step + 1] - times[w.step];
    const double s = (t - times[w.step]) / h;
    w.x0 = (1 + 2 * s) * (1 - s) * (1 - s);
    w.v0 = h * s * (1 - s) * (1 - s);
    w.x1 = s * s * (3 - 2 * s);
    w.v1 = h * s * s * (s - 1);
    w.dx0 = 6 * s * (s - 1) / h;
    w.dv0 = (1 - s) * (1 - 3 * s);
    w.dx1 = -w.dx0;
    w.dv1 = s * (3 * s - 2);
    return w;
}

}  // namespace myo::measurement
