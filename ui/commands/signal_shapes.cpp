#include "commands/signal_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace myo::ui::commands {
namespace {

constexpr double step_rise_s = 1e-3;       // rise time of a step: a signal is continuous
constexpr double closest_knots_s = 1e-4;   // minimum distance of knots
constexpr double knots_per_period = 32.0;  // of a sine

}  // namespace

fibre::Signal make_signal(const SignalRecipe& recipe) {
    switch (recipe.shape) {
        case SignalShape::constant: return fibre::Signal::constant(recipe.level);
        case SignalShape::step: return {{recipe.start_s, recipe.start_s + step_rise_s}, {1.0, recipe.level}};
        case SignalShape::ramp:
            return {{recipe.start_s, recipe.start_s + std::max(step_rise_s, recipe.rise_s)}, {1.0, recipe.level}};
        case SignalShape::sine: break;
    }
    fibre::Signal signal{{}, {}};
    // The number of periods may be fractional; the last knot lies exactly at the end.
    const double whole = std::max(0.0, recipe.end_s - recipe.start_s) * recipe.frequency_Hz;  // periods
    const auto knots = static_cast<int>(std::ceil(whole * knots_per_period));
    for (int k = 0; k <= knots; ++k) {
        // In periods since the start.
        const double period = std::min(whole, k / knots_per_period);
        signal.times_s.push_back(recipe.start_s + period / recipe.frequency_Hz);
        signal.values.push_back(1.0 + 0.5 * (recipe.level - 1.0) * (1.0 - std::cos(2.0 * std::numbers::pi * period)));
    }
    return signal;
}

fibre::Signal with_knot_moved(fibre::Signal signal, std::size_t knot, double time_s, double value) {
    std::vector<double>& times = signal.times_s;
    // The two knots of a jump move together, so that it stays one.
    std::size_t first = knot, last = knot;
    while (first > 0 && times[first - 1] == times[knot]) --first;
    while (last + 1 < times.size() && times[last + 1] == times[knot]) ++last;
    const double far = std::numeric_limits<double>::infinity();
    const double earliest = first > 0 ? times[first - 1] + closest_knots_s : -far;
    const double latest = last + 1 < times.size() ? times[last + 1] - closest_knots_s : far;
    // Two neighbours may be too close for any place between them; then only the value changes.
    if (earliest <= latest)
        for (std::size_t k = first; k <= last; ++k) times[k] = std::clamp(time_s, earliest, latest);
    signal.values[knot] = value;
    return signal;
}

fibre::Signal with_knot_added(fibre::Signal signal, double time_s, double value) {
    const auto after = std::upper_bound(signal.times_s.begin(), signal.times_s.end(), time_s);
    const auto place = after - signal.times_s.begin();
    // Knots closer than this look like one in the plot, and the signal jumps there.
    const bool crowded = (after != signal.times_s.end() && *after - time_s < closest_knots_s) ||
                         (place > 0 && time_s - *(after - 1) < closest_knots_s);
    if (crowded) return signal;
    signal.times_s.insert(after, time_s);
    signal.values.insert(signal.values.begin() + place, value);
    return signal;
}

fibre::Signal with_knot_removed(fibre::Signal signal, std::size_t knot) {
    if (signal.times_s.size() < 2) return signal;
    signal.times_s.erase(signal.times_s.begin() + static_cast<std::ptrdiff_t>(knot));
    signal.values.erase(signal.values.begin() + static_cast<std::ptrdiff_t>(knot));
    return signal;
}

}  // namespace myo::ui::commands
