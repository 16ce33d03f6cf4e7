#include "fibre/signal.hpp"

#include <algorithm>
#include <cassert>

namespace myo {
namespace {

// Linear interpolation between the knots next - 1 and next; `next` counts the knots left of t.
double interpolate(const Signal& signal, double t, std::size_t next) {
    if (next == 0) return signal.values.front();
    if (next == signal.times_s.size()) return signal.values.back();
    const double left = signal.times_s[next - 1], right = signal.times_s[next];
    const double s = (t - left) / (right - left);
    return (1.0 - s) * signal.values[next - 1] + s * signal.values[next];
}

}  // namespace

double Signal::value(double t) const {
    assert(!times_s.empty() && times_s.size() == values.size());
    return interpolate(*this, t, static_cast<std::size_t>(std::upper_bound(times_s.begin(), times_s.end(), t) - times_s.begin()));
}

double Signal::value_before(double t) const {
    return interpolate(*this, t, static_cast<std::size_t>(std::lower_bound(times_s.begin(), times_s.end(), t) - times_s.begin()));
}

std::vector<double> Signal::jumps() const {
    std::vector<double> found;
    for (std::size_t i = 1; i < times_s.size(); ++i)
        if (times_s[i] == times_s[i - 1] && values[i] != values[i - 1]) found.push_back(times_s[i]);
    return found;
}

}  // namespace myo
