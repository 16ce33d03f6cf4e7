#pragma once

#include <vector>

namespace myo {

/// A scalar function of time, linear between its knots and constant outside them.
///
/// times ascend; two equal times are a jump. value() is continuous from the right, value_before() from the left.
struct Signal {
    std::vector<double> times_s{0.0};
    std::vector<double> values{1.0};

    static Signal constant(double value) { return {{0.0}, {value}}; }
    /// `before` for t < time, `after` from then on.
    static Signal step(double time_s, double before, double after) { return {{time_s, time_s}, {before, after}}; }

    double value(double t) const;
    double value_before(double t) const;
    /// Times at which value() and value_before() differ.
    std::vector<double> jumps() const;
};

}  // namespace myo
