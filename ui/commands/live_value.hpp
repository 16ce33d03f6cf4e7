#pragma once

#include <memory>
#include <mutex>

namespace myo::ui::commands {

/// Hands the latest value of a running job from its thread to the UI thread. Earlier values that were not taken are
/// dropped. Both functions may be called from any thread.
template <class Value>
class LiveValue {
public:
    /// Replaces the value. Called by the job.
    void set(std::shared_ptr<const Value> value) {
        const std::lock_guard lock(mutex_);
        latest_ = std::move(value);
    }
    /// Returns the value set since the last call; null if there is none. Called once per frame.
    std::shared_ptr<const Value> take() {
        const std::lock_guard lock(mutex_);
        return std::move(latest_);
    }

private:
    std::mutex mutex_;
    std::shared_ptr<const Value> latest_;
};

}  // namespace myo::ui::commands
