#include "base/abandonable.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

#include "base/cancellation.hpp"

namespace myo {
namespace {

struct AbandonPolicy {
    /// Time between two looks at the request: a tenth of what a person sees as immediate.
    std::chrono::milliseconds look{10};
};
constexpr AbandonPolicy abandon_policy;

std::atomic<int> abandoned{0};

/// What the caller and the thread share.
struct Call {
    std::mutex mutex;
    std::condition_variable ended;
    bool done = false, left = false;
    std::exception_ptr failure;
};

}  // namespace

bool run_abandonable(const std::function<void()>& work) {
    if (cancellation_in_scope() == nullptr) {
        work();
        return true;
    }
    const auto call = std::make_shared<Call>();
    std::thread([call, own = std::function<void()>(work)]() mutable {
        std::exception_ptr failure;
        try {
            own();
        } catch (...) {
            failure = std::current_exception();
        }
        own = nullptr;  // frees what it owns before it counts as ended
        const std::lock_guard<std::mutex> lock(call->mutex);
        call->done = true;
        call->failure = failure;
        if (call->left) --abandoned;
        call->ended.notify_one();
    }).detach();
    std::unique_lock<std::mutex> lock(call->mutex);
    while (!call->done) {
        if (cancellation_requested()) {
            call->left = true;
            ++abandoned;
            return false;
        }
        call->ended.wait_for(lock, abandon_policy.look);
    }
    if (call->failure) std::rethrow_exception(call->failure);
    return true;
}

int abandoned_calls() { return abandoned; }

}  // namespace myo
