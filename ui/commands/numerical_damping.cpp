#include "commands/numerical_damping.hpp"

#include <cmath>
#include <numbers>

namespace myo {

double implicit_euler_damping_ratio(double omega, double h) {
    const double x = omega * h;
    if (!(x > 0.0)) return 0.0;
    constexpr double pi = std::numbers::pi;
    const double delta = pi * std::log1p(x * x) / std::atan(x);
    return delta / std::sqrt(4.0 * pi * pi + delta * delta);
}

}  // namespace myo
