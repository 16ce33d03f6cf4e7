#pragma once

#include <vector>

namespace myo::fibre {

/// A scalar function of time, linear between its knots and constant outside them.
///
/// times ascend; two equal times are a jump. value() is continuous from the right, value_before() from the left.
struct Signal {
    std::vector<double> times_s{0.0};
    std::vector<double> values{1.0};

    static Signal constant(double value) { return {{0.0}, {value}}; }
    /// `before` for t < time, `after` from then on.
    static Signal step(double time_s, double before, double after) { return {{time_s, time_s}, {before, after}}; }
    /// Sample k from times_s[k] to times_s[k + 1], the last for ever and the first before, too. Times ascend strictly.
    static Signal held(const std::vector<double>& times_s, const std::vector<double>& samples);

    double value(double t) const;
    double value_before(double t) const;
    /// value(t), or value_before(t), as a combination of two knots: derivatives with respect to their values.
    struct Weights {
        std::size_t left = 0, right = 0;
        double of_left = 1.0, of_right = 0.0;
    };
    Weights weights(double t, bool before) const;

    /// Times of two equal knots, also where their values are equal: the steps of a run, and with them its derivative,
    /// shall not depend on values.
    std::vector<double> jumps() const;

    bool operator==(const Signal&) const = default;
};

/// The derivative with respect to the samples of Signal::held() from the one with respect to its knots.
std::vector<double> held_sample_gradient(const std::vector<double>& knot_gradient);

}  // namespace myo::fibre
