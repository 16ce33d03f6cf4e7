#pragma once

#include <vector>

#include "fibre/signal.hpp"

namespace myo::model {

/// Whether the motor of a tendon takes in or pays out, from its command: in while it grows, out while it falls. A
/// constant command keeps the sense; the first is to take in.
///
/// A reversal counts from a hundredth of the range of the command on: recorded commands carry noise.
class TakingIn {
public:
    explicit TakingIn(const fibre::Signal& command);

    /// 1 while taking in, -1 while paying out, at `time_s` or just before it.
    double at(double time_s, bool before) const;
    /// Times at which the sense changes.
    std::vector<double> turns() const;

private:
    std::vector<double> times_s_;
    std::vector<double> senses_;  // before the first knot, then after each
};

}  // namespace myo::model
