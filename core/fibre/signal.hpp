#pragma once

#include <vector>

namespace myo::fibre {

/// Piecewise linear function of time, constant outside its knots.
///
/// Knot times ascend; two equal times are a jump. value() is the right limit, value_before() the left limit.
struct Signal {
    std::vector<double> times_s{0.0};  // ascending
    std::vector<double> values{1.0};   // one per time

    /// Constant signal.
    static Signal constant(double value) { return {{0.0}, {value}}; }
    /// Jump at `time_s`: `before` for t < time_s, `after` from then on.
    static Signal step(double time_s, double before, double after) { return {{time_s, time_s}, {before, after}}; }
    /// Zero-order hold: sample k from times_s[k] to times_s[k + 1], the first also before, the last also after. Times
    /// must ascend strictly.
    static Signal held(const std::vector<double>& times_s, const std::vector<double>& samples);

    /// Value at t [s], right limit at a jump.
    double value(double t) const;
    /// Value at t [s], left limit at a jump.
    double value_before(double t) const;
    /// Value as a linear combination of two knots, that is its derivatives with respect to the knot values.
    struct Weights {
        std::size_t left = 0, right = 0;       // knot indices
        double of_left = 1.0, of_right = 0.0;  // coefficients; of_right unused if left == right
    };
    /// Coefficients of value(t), or of value_before(t) if `before`.
    Weights weights(double t, bool before) const;

    /// Times of pairs of equal knots, even if their values are equal: the time steps of a run, and hence its
    /// derivatives, must not depend on values.
    std::vector<double> jumps() const;

    bool operator==(const Signal&) const = default;
};

/// Derivative with respect to the samples of Signal::held(), from the derivative with respect to its knots.
std::vector<double> held_sample_gradient(const std::vector<double>& knot_gradient);

}  // namespace myo::fibre
