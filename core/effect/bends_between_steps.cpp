#include "effect/bends_between_steps.hpp"

#include <algorithm>
#include <cmath>

namespace myo::effect {
namespace {

/// Coefficient of the second difference. Stages at the fractions c of a step with weights b give the mean over a step
/// the impulse of a line with slope s plus (Σ b (c - 1/2)²) / 2 h² s. For TR-BDF2, b = (√2/4, √2/4, 1 - √2/2) and c =
/// (0, 2 - √2, 1), this is (√2 - 5/4) / 2 h² s; the second difference of a kink sums to h s.
const double sharpening = 0.5 * (std::sqrt(2.0) - 1.25);

/// Integral of the piecewise linear signal from its first knot to t.
class Integral {
public:
    explicit Integral(const fibre::Signal& signal) : signal_(signal), at_knots_{0.0} {
        for (std::size_t k = 1; k < signal.times_s.size(); ++k)
            at_knots_.push_back(at_knots_.back() + 0.5 * (signal.values[k] + signal.values[k - 1]) *
                                                       (signal.times_s[k] - signal.times_s[k - 1]));
    }

    /// Constant extension: before the first knot and beyond the last one the signal keeps its value.
    double to(double t) const {
        const auto after = std::upper_bound(signal_.times_s.begin(), signal_.times_s.end(), t);
        const auto k = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - signal_.times_s.begin() - 1, 0));
        return at_knots_[k] + 0.5 * (signal_.values[k] + signal_.value(t)) * (t - signal_.times_s[k]);
    }

private:
    const fibre::Signal& signal_;
    std::vector<double> at_knots_;
};

struct BendsBetweenStepsPolicy {
    /// The means and their second difference extend this many steps to each side.
    double reach = 1.5;
};
constexpr BendsBetweenStepsPolicy bends_between_steps_policy;

/// Jump of a signal by `change`.
struct Jump {
    double time_s = 0.0, change = 0.0;
};

/// Removes the jumps before `until_s` from the signal and returns them.
std::vector<Jump> take_jumps(fibre::Signal& signal, double until_s) {
    std::vector<Jump> jumps;
    double taken = 0.0;
    for (std::size_t k = 0; k < signal.times_s.size(); ++k) {
        const bool jumps_here = k > 0 && signal.times_s[k] == signal.times_s[k - 1] && signal.times_s[k] < until_s;
        // Jumps removed before have already lowered the left value.
        const double change = jumps_here ? signal.values[k] - taken - signal.values[k - 1] : 0.0;
        if (change != 0.0) jumps.push_back({signal.times_s[k], change});
        taken += change;
        signal.values[k] -= taken;
    }
    return jumps;
}

/// The signal plus a step function at the jump, as two knots of equal time.
fibre::Signal with_jump(const fibre::Signal& signal, const Jump& jump) {
    fibre::Signal result{{}, {}};
    const auto add = [&](double t, double value) {
        result.times_s.push_back(t);
        result.values.push_back(value);
    };
    std::size_t k = 0;
    for (; k < signal.times_s.size() && signal.times_s[k] < jump.time_s; ++k) add(signal.times_s[k], signal.values[k]);
    add(jump.time_s, signal.value_before(jump.time_s));
    for (add(jump.time_s, signal.value(jump.time_s) + jump.change); k < signal.times_s.size(); ++k)
        if (signal.times_s[k] > jump.time_s) add(signal.times_s[k], signal.values[k] + jump.change);
    return result;
}

/// Whether all values are equal.
bool is_constant(const fibre::Signal& signal) {
    return std::all_of(signal.values.begin(), signal.values.end(),
                       [&](double value) { return value == signal.values.front(); });
}

}  // namespace

fibre::Signal with_bends_between_steps(const fibre::Signal& signal, double h_s, double end_s) {
    fibre::Signal rest = signal;
    const std::vector<Jump> kept = take_jumps(rest, bends_between_steps_policy.reach * h_s);
    // Unchanged to the last bit, jumps included.
    if (is_constant(rest)) return signal;
    const Integral integral(rest);
    const auto mean = [&](double t) { return (integral.to(t + 0.5 * h_s) - integral.to(t - 0.5 * h_s)) / h_s; };
    // Four knots per step, up to one beyond the end.
    const auto count = static_cast<std::size_t>(std::ceil(4.0 * end_s / h_s)) + 2;
    fibre::Signal result{{}, {}};
    for (std::size_t k = 0; k < count; ++k) {
        const double t = 0.25 * static_cast<double>(k) * h_s, around = mean(t);
        result.times_s.push_back(t);
        result.values.push_back(around - sharpening * (mean(t + h_s) - 2.0 * around + mean(t - h_s)));
    }
    result.values.front() = rest.value_before(0.0);  // the body starts under the value before t = 0
    // In the order of time: with_jump() raises everything after its jump.
    for (const Jump& jump : kept) result = with_jump(result, jump);
    return result;
}

}  // namespace myo::effect
