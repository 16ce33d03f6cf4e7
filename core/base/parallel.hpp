#pragma once

#include <functional>

namespace myo {

/// Runs task(0) ... task(count - 1) on up to `threads` threads; returns when all are done.
///
/// Each index is run exactly once by one thread; results that a task writes to its own slot do not
/// depend on the number of threads. The first exception of the lowest index is rethrown.
void parallel_tasks(int count, int threads, const std::function<void(int)>& task);

/// Number of hardware threads, at least 1.
int hardware_threads();

}  // namespace myo
