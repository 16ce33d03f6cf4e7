#pragma once

#include <atomic>
#include <chrono>

namespace myo {

/// Limits the rate of display updates: ready() returns true at once, then at most ten times a second, which is fast
/// enough to read. Thread-safe.
class Throttle {
public:
    bool ready() {
        const Clock::rep now = Clock::now().time_since_epoch().count();
        Clock::rep next = next_.load(std::memory_order_relaxed);
        return now >= next &&
               next_.compare_exchange_strong(next, now + Clock::duration(std::chrono::milliseconds(100)).count());
    }

private:
    using Clock = std::chrono::steady_clock;
    std::atomic<Clock::rep> next_{Clock::time_point::min().time_since_epoch().count()};
};

}  // namespace myo
