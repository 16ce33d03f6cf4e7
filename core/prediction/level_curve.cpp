#include "prediction/level_curve.hpp"

#include <algorithm>
#include <cassert>

namespace myo::prediction {
namespace {

/// Slope at an inner point: weighted harmonic mean of the neighbouring secants, zero at an extremum. This choice keeps
/// the cubic monotone between the points (Fritsch & Butland 1984).
double inner_slope(double h0, double h1, double s0, double s1) {
    if (s0 * s1 <= 0.0) return 0.0;
    const double w0 = 2.0 * h1 + h0, w1 = h1 + 2.0 * h0;
    return (w0 + w1) / (w0 / s0 + w1 / s1);
}

}  // namespace

double curve_through(const std::vector<double>& x, const std::vector<double>& y, double at, double value_at_zero) {
    assert(!x.empty() && x.size() == y.size());
    const std::size_t n = x.size();
    if (n == 1) return x[0] == 0.0 ? y[0] : value_at_zero + (y[0] - value_at_zero) / x[0] * at;
    std::vector<double> h, secant, slope(n);
    for (std::size_t i = 0; i + 1 < n; ++i) {
        h.push_back(x[i + 1] - x[i]);
        secant.push_back((y[i + 1] - y[i]) / h.back());
    }
    // End slopes equal the outer secants, so the extrapolation is linear.
    slope.front() = secant.front();
    slope.back() = secant.back();
    for (std::size_t i = 1; i + 1 < n; ++i) slope[i] = inner_slope(h[i - 1], h[i], secant[i - 1], secant[i]);
    if (at <= x.front()) return y.front() + slope.front() * (at - x.front());
    if (at >= x.back()) return y.back() + slope.back() * (at - x.back());
    const auto i = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), at) - x.begin()) - 1;
    const double s = (at - x[i]) / h[i];
    // Cubic Hermite basis in s = (at - x_i) / h_i.
    return (1 + 2 * s) * (1 - s) * (1 - s) * y[i] + h[i] * s * (1 - s) * (1 - s) * slope[i] +
           s * s * (3 - 2 * s) * y[i + 1] + h[i] * s * s * (s - 1) * slope[i + 1];
}

}  // namespace myo::prediction
