#pragma once

#include <functional>

namespace myo {

/// Runs task(0) ... task(count - 1) on up to `threads` threads, all loops inside them included; returns when all are
/// done.
///
/// Each index is run exactly once by one thread; results that a task writes to its own slot do not
/// depend on the number of threads. The first exception of the lowest index is rethrown.
void parallel_tasks(int count, int threads, const std::function<void(int)>& task);

/// Calls range(first, end) for consecutive ranges that cover 0 ... count - 1, at least `grain` long, on the threads
/// that the surrounding parallel_tasks() left free (all of the machine's outside of one). What a range writes to slots
/// of its own does not depend on their number. A thread that waits here takes up nothing else meanwhile, so `range` may
/// use its thread's storage.
void parallel_ranges(int count, int grain, const std::function<void(int, int)>& range);

/// Number of hardware threads, at least 1.
int hardware_threads();

}  // namespace myo
