#include "fibre/signal.hpp"

#include <algorithm>
#include <cassert>

namespace myo::fibre {
namespace {

// Linear interpolation between knots next - 1 and next, where `next` is the number of knots left of t.
Signal::Weights interpolation(const Signal& signal, double t, std::size_t next) {
    if (next == 0) return {0, 0};
    if (next == signal.times_s.size()) return {next - 1, next - 1};
    const double left = signal.times_s[next - 1], right = signal.times_s[next];
    const double s = (t - left) / (right - left);
    return {next - 1, next, 1.0 - s, s};
}

double weighted(const Signal& signal, const Signal::Weights& w) {
    return w.left == w.right ? signal.values[w.left]
                             : w.of_left * signal.values[w.left] + w.of_right * signal.values[w.right];
}

}  // namespace

Signal::Weights Signal::weights(double t, bool before) const {
    assert(!times_s.empty() && times_s.size() == values.size());
    // Left limit: knots at t are excluded from the left side; right limit: included.
    const auto next = before ? std::lower_bound(times_s.begin(), times_s.end(), t)
                             : std::upper_bound(times_s.begin(), times_s.end(), t);
    return interpolation(*this, t, static_cast<std::size_t>(next - times_s.begin()));
}

double Signal::value(double t) const { return weighted(*this, weights(t, false)); }
double Signal::value_before(double t) const { return weighted(*this, weights(t, true)); }

Signal Signal::held(const std::vector<double>& times_s, const std::vector<double>& samples) {
    assert(!times_s.empty() && times_s.size() == samples.size());
    Signal signal{{times_s.front()}, {samples.front()}};
    for (std::size_t k = 1; k < times_s.size(); ++k) {
        // Two knots per sample boundary: end of one sample and start of the next.
        signal.times_s.insert(signal.times_s.end(), 2, times_s[k]);
        signal.values.insert(signal.values.end(), {samples[k - 1], samples[k]});
    }
    return signal;
}

std::vector<double> held_sample_gradient(const std::vector<double>& knot_gradient) {
    std::vector<double> samples((knot_gradient.size() + 1) / 2, 0.0);
    for (std::size_t i = 0; i < knot_gradient.size(); ++i) samples[i / 2] += knot_gradient[i];
    return samples;
}

std::vector<double> Signal::jumps() const {
    std::vector<double> found;
    for (std::size_t i = 1; i < times_s.size(); ++i)
        if (times_s[i] == times_s[i - 1]) found.push_back(times_s[i]);
    return found;
}

}  // namespace myo::fibre
