#pragma once

#include <algorithm>

#include "base/stopwatch.hpp"

namespace myo::backend {

/// Limits how often the best result is displayed: drawing may take a fifth of the time.
class Pace {
public:
    /// Whether the next best result is to be displayed: the first at once, then at most every half second, and after a
    /// pause of four times the cost of the last one.
    bool due() const { return first_ || since_.seconds() > std::max(0.5, 4.0 * cost_s_); }
    /// Reports the cost of a display [s]; its pause begins now.
    void took(double seconds) {
        cost_s_ = seconds;
        first_ = false;
        since_ = Stopwatch();
    }

private:
    bool first_ = true;
    double cost_s_ = 0.0;
    Stopwatch since_;
};

}  // namespace myo::backend
