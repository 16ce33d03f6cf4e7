#include "base/parallel.hpp"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <exception>
#include <thread>
#include <vector>

namespace myo {

void parallel_tasks(int count, int threads, const std::function<void(int)>& task) {
    if (count <= 0) return;
    std::vector<std::exception_ptr> failures(static_cast<std::size_t>(count));
    const auto guarded = [&](int i) {
        try {
            task(i);
        } catch (...) {
            failures[static_cast<std::size_t>(i)] = std::current_exception();
        }
    };
    // The arena holds the loops inside the tasks, too: two trials on two threads leave no thread to their steps.
    tbb::task_arena arena(std::clamp(threads, 1, hardware_threads()));
    arena.execute([&] { tbb::parallel_for(0, count, guarded, tbb::simple_partitioner()); });
    for (const std::exception_ptr& failure : failures)
        if (failure) std::rethrow_exception(failure);
}

void parallel_ranges(int count, int grain, const std::function<void(int, int)>& range) {
    if (count <= 0) return;
    const int parts = std::min(tbb::this_task_arena::max_concurrency(), count / std::max(grain, 1));
    if (parts <= 1) return range(0, count);
    const auto start_of = [&](int part) { return static_cast<int>(static_cast<long>(count) * part / parts); };
    tbb::this_task_arena::isolate([&] { tbb::parallel_for(0, parts, [&](int part) { range(start_of(part), start_of(part + 1)); }, tbb::static_partitioner()); });
}

int hardware_threads() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

}  // namespace myo
