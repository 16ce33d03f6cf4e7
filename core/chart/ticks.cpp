#include "chart/ticks.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <initializer_list>

#include "base/markup.hpp"

namespace myo::chart {
namespace {

// Ticks at powers of ten whose exponent is a multiple of `every`, and at 2 and 5 times these if `between`.
Ticks decade_ticks(double lowest, double highest, int every, bool between) {
    Ticks ticks{lowest, highest, {}, {}, {}};
    // Plain decimals where all values are moderate, powers of ten otherwise: one axis does not mix them.
    const bool plain = lowest >= 0.01 * (1 - 1e-12) && highest < 1e4 * (1 - 1e-12);
    for (int k = static_cast<int>(std::floor(std::log10(lowest))); k <= std::ceil(std::log10(highest)); ++k) {
        if (k % every != 0) continue;
        for (const int factor : {1, 2, 5}) {
            if (factor > 1 && !between) break;
            const double value = factor * std::pow(10.0, k);
            // The tolerance keeps ticks at the ends of the range.
            if (value < lowest * (1 - 1e-12) || value > highest * (1 + 1e-12)) continue;
            ticks.values.push_back(std::clamp(value, lowest, highest));
            if (plain)
                ticks.labels.push_back(fixed_decimals(value, std::max(0, -k)));
            else
                ticks.labels.push_back((factor == 1 ? std::string{} : std::to_string(factor) + "·") + power_of_ten(k));
        }
    }
    return ticks;
}

/// Exponent of the leading digit; the tolerance keeps exact powers of ten.
int floor_log10(double value) { return static_cast<int>(std::floor(std::log10(value) + 1e-9)); }

}  // namespace

double round_step(double raw) {
    assert(raw > 0.0 && std::isfinite(raw));
    const double power = std::pow(10.0, std::floor(std::log10(raw)));
    // A rounding error must not increase 0.2 to 0.5.
    for (const double factor : {1.0, 2.0, 5.0})
        if (raw <= factor * power * (1.0 + 1e-9)) return factor * power;
    return 10.0 * power;
}

void make_drawable(double& lowest, double& highest) {
    if (!std::isfinite(lowest) || !std::isfinite(highest) || lowest > highest) {
        lowest = 0.0;
        highest = 1.0;
        return;
    }
    // Differences and squares of the values must not overflow, spacings must not underflow.
    lowest = std::clamp(lowest, -1e150, 1e150);
    highest = std::clamp(highest, -1e150, 1e150);
    const double size = std::max(std::abs(lowest), std::abs(highest));
    if (size < 1e-150) {
        lowest = -1.0;
        highest = 1.0;
    } else if (highest - lowest < 1e-9 * size) {
        lowest -= 0.05 * size;
        highest += 0.05 * size;
    }
}

Ticks linear_ticks(double lowest, double highest, int wanted) {
    make_drawable(lowest, highest);
    Ticks ticks{lowest, highest, {}, {}, {}};
    double step = round_step((highest - lowest) / std::max(wanted, 2));
    double first = 0.0, last = 0.0;
    // Few wanted ticks can give a spacing with fewer than two multiples in the range: reduce it.
    for (int attempt = 0; attempt < 3; ++attempt) {
        first = std::ceil(lowest / step - 1e-9);
        last = std::floor(highest / step + 1e-9);
        if (last - first >= 1.0) break;
        step = round_step(0.4 * step);
    }
    // Labels of very large or small values are scaled by a power of 1000, shown once at the axis.
    const double size = std::max(std::abs(lowest), std::abs(highest));
    const int magnitude = floor_log10(size);
    // Multiples of 3 correspond to SI prefixes.
    const int exponent = magnitude >= 5 || magnitude < -3 ? 3 * static_cast<int>(std::floor(magnitude / 3.0)) : 0;
    const double unit = std::pow(10.0, exponent);
    if (exponent != 0) ticks.factor = power_of_ten(exponent);
    // As many decimals as the spacing needs, so that neighbouring labels differ.
    const int decimals = std::max(0, exponent - floor_log10(step));
    for (double k = first; k <= last; k += 1.0) {
        // Rounding can move a multiple out of the range.
        const double value = std::clamp(k * step, lowest, highest);
        ticks.values.push_back(value);
        ticks.labels.push_back(fixed_decimals(k * step / unit, decimals));
    }
    return ticks;
}

Ticks logarithmic_ticks(double lowest, double highest, int wanted) {
    if (!(lowest > 0.0) || !(highest >= lowest) || !std::isfinite(highest)) {
        lowest = 1.0;
        highest = 10.0;
    }
    lowest = std::clamp(lowest, 1e-150, 1e150);
    highest = std::clamp(highest, 1e-150, 1e150);
    // Too narrow for ticks: widen by a factor of 2 on both sides.
    if (highest < lowest * 1.2) {
        lowest /= 2.0;
        highest *= 2.0;
    }
    const double decades = std::log10(highest / lowest);
    // Every decade, or every second, third, ... one; fewer decades if this gives fewer than two ticks.
    for (int every = std::max(1, static_cast<int>(std::ceil(decades / std::max(wanted, 2)))); every >= 1; --every) {
        const Ticks ticks = decade_ticks(lowest, highest, every, decades < 2.5);
        if (ticks.values.size() >= 2) return ticks;
    }
    return linear_ticks(lowest, highest, wanted);  // range between two neighbouring round numbers
}

}  // namespace myo::chart
