#include "base/parallel.hpp"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <exception>
#include <thread>
#include <vector>

#include "base/cancellation.hpp"

namespace myo {
namespace {

/// Threads for the loops inside the current task. With as many tasks as threads this is 1: a loop that waited for a
/// thread busy with another task took three times as long as one that did all its work itself.
thread_local int free_threads = 0;  // 0: outside of all tasks, where the whole machine is available

/// Sets free_threads for one scope, so that nested loops and exceptions restore it.
class FreeThreads {
public:
    explicit FreeThreads(int count) : before_(free_threads) { free_threads = count; }
    ~FreeThreads() { free_threads = before_; }
    FreeThreads(const FreeThreads&) = delete;
    FreeThreads& operator=(const FreeThreads&) = delete;

private:
    int before_;
};

}  // namespace

void parallel_tasks(int count, int threads, const std::function<void(int)>& task) {
    if (count <= 0) return;
    std::vector<std::exception_ptr> failures(static_cast<std::size_t>(count));
    threads = std::clamp(threads, 1, hardware_threads());
    // Exceptions are collected instead of propagated, because TBB would cancel the remaining tasks and report an
    // arbitrary one.
    const Progress* const task_progress = cancellation_in_scope();
    const auto guarded = [&](int i) {
        const CancellationScope scope(task_progress);
        const FreeThreads inside(std::max(1, threads / count));
        try {
            task(i);
        } catch (...) {
            failures[static_cast<std::size_t>(i)] = std::current_exception();
        }
    };
    tbb::task_arena arena(threads);
    arena.execute([&] { tbb::parallel_for(0, count, guarded, tbb::simple_partitioner()); });
    for (const std::exception_ptr& failure : failures)
        if (failure) std::rethrow_exception(failure);
}

void parallel_ranges(int count, int grain, const std::function<void(int, int)>& range) {
    if (count <= 0) return;
    const int threads = free_threads > 0 ? free_threads : tbb::this_task_arena::max_concurrency();
    const int parts = std::min(threads, count / std::max(grain, 1));
    if (parts <= 1) return range(0, count);
    // Bounds from integer arithmetic on count and part alone: they do not depend on scheduling.
    const auto start_of = [&](int part) { return static_cast<int>(static_cast<long>(count) * part / parts); };
    const Progress* const task_progress = cancellation_in_scope();
    const auto guarded = [&](int part) {
        const CancellationScope scope(task_progress);
        const FreeThreads inside(threads);
        range(start_of(part), start_of(part + 1));
    };
    // isolate() keeps the waiting thread from starting an unrelated task, whose thread-local storage would collide.
    // The caller must do what no other thread has begun: a static partitioner leaves parts to threads that may sleep or
    // be busy elsewhere, and a run took four times as long with two threads as with one.
    tbb::this_task_arena::isolate([&] { tbb::parallel_for(0, parts, guarded, tbb::simple_partitioner()); });
}

int hardware_threads() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

}  // namespace myo
