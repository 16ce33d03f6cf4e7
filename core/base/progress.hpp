#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <utility>

namespace myo {

/// One progress event of a long task: `done` of `total`, counted in `unit` ("steps", "evaluations").
struct ProgressEvent {
    std::string task;
    double done = 0.0;
    double total = 0.0;
    std::string unit;
    std::string message;
};

/// Where a long task reports to and asks whether it shall stop. Thread-safe when the sink is.
///
/// Copies share the cancel flag, so the owner of a job keeps one and hands out another.
class Progress {
public:
    using Sink = std::function<void(const ProgressEvent&)>;

    Progress() = default;
    explicit Progress(Sink sink, std::atomic<bool>* cancel = nullptr) : sink_(std::move(sink)), cancel_(cancel) {}

    void report(const ProgressEvent& event) const {
        if (sink_) sink_(event);
    }
    /// The same cancel flag with another sink (none: silent).
    Progress with_sink(Sink sink) const { return Progress(std::move(sink), cancel_); }

    bool cancelled() const { return cancel_ != nullptr && cancel_->load(std::memory_order_relaxed); }

private:
    Sink sink_;
    std::atomic<bool>* cancel_ = nullptr;
};

}  // namespace myo
