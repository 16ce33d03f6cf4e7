#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <string>
#include <utility>

namespace myo {

/// Progress of a long task: `done` of `total`, both counted in `unit`.
struct ProgressEvent {
    std::string task;     // name shown to the user
    double done = 0.0;    // completed amount [unit]
    double total = 0.0;   // full amount [unit]
    std::string unit;     // "steps", "evaluations", ...
    std::string message;  // optional detail
};

/// Sink for progress reports plus the cancel flag of a long task. Thread-safe if the sink is.
///
/// Copies share the cancel flag: the owner of a job keeps one copy and passes another to the job.
class Progress {
public:
    using Sink = std::function<void(const ProgressEvent&)>;
    using Moment = std::chrono::steady_clock::time_point;

    Progress() = default;
    explicit Progress(Sink sink, std::atomic<bool>* cancel = nullptr) : sink_(std::move(sink)), cancel_(cancel) {}

    /// Passes an event to the sink, if there is one.
    void report(const ProgressEvent& event) const {
        if (sink_) sink_(event);
    }
    /// Copy with the same cancel flag and another sink; an empty sink discards the reports.
    Progress with_sink(Sink sink) const {
        Progress copy(std::move(sink), cancel_);
        copy.end_ = end_;
        return copy;
    }
    /// Copy that is also cancelled from a moment on. An earlier such moment stays.
    Progress until(Moment end) const {
        Progress copy = *this;
        copy.end_ = std::min(end_, end);
        return copy;
    }

    /// Moment from which on it is cancelled; the last of the clock without a limit.
    Moment end() const { return end_; }

    /// True once cancellation was requested or the time is over. Long loops poll this and return early.
    bool cancelled() const {
        return (cancel_ != nullptr && cancel_->load(std::memory_order_relaxed)) ||
               (end_ != Moment::max() && std::chrono::steady_clock::now() >= end_);
    }

private:
    Sink sink_;
    std::atomic<bool>* cancel_ = nullptr;
    Moment end_ = Moment::max();
};

}  // namespace myo
