#pragma once

#include <algorithm>
#include <vector>

namespace myo::measurement {

/// Values and time derivative on the Hermite curve of one step interval.
struct HermiteWeights {
    std::size_t step = 0;                               // interval [step, step + 1]
    double x0 = 1.0, v0 = 0.0, x1 = 0.0, v1 = 0.0;      // position
    double dx0 = 0.0, dv0 = 0.0, dx1 = 0.0, dv1 = 0.0;  // velocity

    /// The weights of the velocity in the place of those of the position.
    HermiteWeights rate() const { return {step, dx0, dv0, dx1, dv1}; }
};

/// @param times  of the steps, ascending
inline HermiteWeights hermite_weights(const std::vector<double>& times, double t) {
    HermiteWeights w;
    if (t <= times.front() || times.size() == 1) return w;  // at rest before the start
    if (t >= times.back()) {
        w.step = times.size() - 2;
        w.x0 = 0.0;
        w.x1 = 1.0;
        w.dv1 = t > times.back() ? 0.0 : 1.0;  // it stays there
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
