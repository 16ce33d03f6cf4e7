#pragma once

#include <memory>
#include <mutex>

namespace myo::ui::commands {

/// What a running job knows so far, on its way from its thread to the frame: the latest only.
template <class Value>
class LiveValue {
public:
    void set(std::shared_ptr<const Value> value) {
        const std::lock_guard lock(mutex_);
        latest_ = std::move(value);
    }
    /// What came since the last call; null when nothing did.
    std::shared_ptr<const Value> take() {
        const std::lock_guard lock(mutex_);
        return std::move(latest_);
    }

private:
    std::mutex mutex_;
    std::shared_ptr<const Value> latest_;
};

}  // namespace myo::ui::commands
