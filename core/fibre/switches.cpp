#include "fibre/switches.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

namespace myo::fibre {
namespace {

/// Monotone sequence of intervals first ... last - 1 between knots.
struct Rise {
    std::size_t first = 0, last = 0;
};

double change(const Signal& s, std::size_t interval) { return s.values[interval + 1] - s.values[interval]; }
double length(const Signal& s, std::size_t interval) { return s.times_s[interval + 1] - s.times_s[interval]; }
double slope(const Signal& s, std::size_t interval) {
    return length(s, interval) > 0.0 ? change(s, interval) / length(s, interval) : 0.0;
}

/// Rise around its steepest interval, including its flanks.
Rise rise_around(const Signal& s, std::size_t steepest, const SwitchRule& rule) {
    const double least = rule.flank_slope * std::abs(slope(s, steepest)), sign = change(s, steepest);
    const auto belongs = [&](std::size_t interval) {
        return slope(s, interval) * sign > 0.0 && std::abs(slope(s, interval)) >= least;
    };
    Rise rise{steepest, steepest + 1};
    while (rise.first > 0 && belongs(rise.first - 1)) --rise.first;
    while (rise.last + 1 < s.times_s.size() && belongs(rise.last)) ++rise.last;
    return rise;
}

/// True if the signal is quiet around the rise, except for similar switches.
bool stands_out(const Signal& s, const Rise& rise, double h, const SwitchRule& rule) {
    const double size = std::abs(s.values[rise.last] - s.values[rise.first]);
    const double from = s.times_s[rise.first] - h, to = s.times_s[rise.last] + h;
    double others = 0.0;
    int similar = 0;
    const auto add = [&](std::size_t interval) {
        const double whole = std::abs(change(s, interval));
        if (!(length(s, interval) > 0.0)) return;  // a jump already
        // A change of similar size and length is counted as another switch instead of noise.
        if (length(s, interval) < h && whole * rule.size_ratio >= size && whole <= rule.size_ratio * size) {
            ++similar;
            return;
        }
        const double within = std::min(to, s.times_s[interval + 1]) - std::max(from, s.times_s[interval]);
        others += whole * std::max(0.0, within) / length(s, interval);
    };
    for (std::size_t i = rise.first; i > 0 && s.times_s[i] > from; --i) add(i - 1);
    for (std::size_t i = rise.last; i + 1 < s.times_s.size() && s.times_s[i] < to; ++i) add(i);
    return others <= rule.quiet_share * size && similar <= rule.max_adjacent;
}

/// Time at which a jump of the same height preserves the integral of the signal.
double jump_time(const Signal& s, const Rise& rise, double grid) {
    const double low = s.values[rise.first], high = s.values[rise.last];
    double integral = 0.0;
    for (std::size_t i = rise.first; i < rise.last; ++i)
        integral += 0.5 * (s.values[i] + s.values[i + 1]) * length(s, i);
    const double exact = (high * s.times_s[rise.last] - low * s.times_s[rise.first] - integral) / (high - low);
    const double per_s = std::round(1.0 / grid), rounded = std::round(exact * per_s) / per_s;
    // The rounded time must not pass a neighbouring knot.
    const bool free = (rise.first == 0 || rounded > s.times_s[rise.first - 1]) &&
                      (rise.last + 1 == s.times_s.size() || rounded < s.times_s[rise.last + 1]);
    return free ? rounded : exact;
}

/// Non-overlapping switches in order of time. The steepest intervals are processed first, so that flanks belong to the
/// dominant rise.
std::vector<Rise> switches(const Signal& s, double h, const SwitchRule& rule) {
    std::vector<std::size_t> steep;
    for (std::size_t i = 0; i + 1 < s.times_s.size(); ++i)
        if (slope(s, i) != 0.0 && length(s, i) < h) steep.push_back(i);
    std::stable_sort(steep.begin(), steep.end(),
                     [&](std::size_t a, std::size_t b) { return std::abs(slope(s, a)) > std::abs(slope(s, b)); });
    std::vector<bool> seen(s.times_s.size(), false);
    std::vector<Rise> found;
    for (const std::size_t i : steep) {
        if (seen[i]) continue;
        const Rise rise = rise_around(s, i, rule);
        bool overlaps = false;
        for (std::size_t k = rise.first; k < rise.last; ++k) {
            overlaps = overlaps || seen[k];
            seen[k] = true;
        }
        // A rise of a full step is a ramp, which the integrator resolves.
        if (overlaps || !(s.times_s[rise.last] - s.times_s[rise.first] < (1.0 - 1e-6) * h)) continue;
        if (stands_out(s, rise, h, rule)) found.push_back(rise);
    }
    std::sort(found.begin(), found.end(), [](const Rise& a, const Rise& b) { return a.first < b.first; });
    return found;
}

}  // namespace

Signal with_switches_as_jumps(const Signal& signal, double h_s, const SwitchRule& rule) {
    assert(h_s > 0.0 && signal.times_s.size() == signal.values.size());
    const std::vector<Rise> rises = switches(signal, h_s, rule);
    if (rises.empty()) return signal;
    Signal result{{}, {}};
    const auto add = [&](double t, double value) {
        result.times_s.push_back(t);
        result.values.push_back(value);
    };
    std::size_t next = 0;
    for (const Rise& rise : rises) {
        const double low = signal.values[rise.first], high = signal.values[rise.last];
        double at = jump_time(signal, rise, rule.time_grid * h_s);
        if (!result.times_s.empty())
            at = std::max(at, result.times_s.back());  // of the previous switch, rounded the other way
        for (; next <= rise.first; ++next)
            if (signal.times_s[next] < at) add(signal.times_s[next], signal.values[next]);
        add(at, low);
        add(at, high);
        next = rise.last;
        if (signal.times_s[next] <= at) ++next;  // the jump was rounded past this knot
    }
    for (; next < signal.times_s.size(); ++next) add(signal.times_s[next], signal.values[next]);
    return result;
}

}  // namespace myo::fibre
