#pragma once

#include <chrono>

namespace myo {

/// Wall-clock time since construction [s]; based on the monotonic clock.
class Stopwatch {
public:
    double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }
    /// Moment at which seconds() is so much.
    std::chrono::steady_clock::time_point at(double seconds) const {
        return start_ +
               std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(seconds));
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Adds its own lifetime to a sum [s].
class TimedScope {
public:
    explicit TimedScope(double& sum_s) : sum_s_(sum_s) {}
    ~TimedScope() { sum_s_ += watch_.seconds(); }
    TimedScope(const TimedScope&) = delete;
    TimedScope& operator=(const TimedScope&) = delete;

private:
    double& sum_s_;
    Stopwatch watch_;
};

}  // namespace myo
