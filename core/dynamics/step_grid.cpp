#include "dynamics/step_grid.hpp"

#include <algorithm>
#include <cmath>

namespace myo::dynamics {

/// Multiples of h close to a jump (5 % of h) are omitted: a step much shorter than h would amplify the rounding of the
/// positions to large accelerations.
std::vector<double> step_ends(const model::Model& model, double h, double end) {
    std::vector<double> ends;
    for (const double t : model::jump_times(model))
        if (t > 1e-6 * h && t < end) ends.push_back(t);
    const std::vector<double> jumps = ends;
    const auto count = static_cast<long>(std::ceil(end / h - 1e-9));
    for (long k = 1; k <= count; ++k) {
        const double t = static_cast<double>(k) * h, beside = k < count ? 0.05 * h : 1e-6 * h;
        if (std::none_of(jumps.begin(), jumps.end(), [&](double jump) { return std::abs(jump - t) <= beside; }))
            ends.push_back(t);
    }
    std::sort(ends.begin(), ends.end());
    std::vector<double> merged;  // jumps within rounding of each other are merged into the last one
    for (const double t : ends) {
        if (!merged.empty() && t - merged.back() <= 1e-6 * h) merged.pop_back();
        merged.push_back(t);
    }
    return merged;
}

bool is_jump(const std::vector<double>& jumps, double t, double h) {
    return std::any_of(jumps.begin(), jumps.end(), [&](double jump) { return std::abs(jump - t) <= 1e-6 * h; });
}

}  // namespace myo::dynamics
