#pragma once

#include <functional>

namespace myo {

/// Runs task(0) ... task(count - 1) in parallel and returns when all are done.
///
/// Each index runs once, on one thread. Results written to a slot per index do not depend on the number of threads.
///
/// @param threads  upper limit of the threads in use, parallel_ranges() inside the tasks included
/// Errors: the exception of the lowest failing index is rethrown after all tasks have ended.
void parallel_tasks(int count, int threads, const std::function<void(int)>& task);

/// Splits 0 ... count - 1 into consecutive ranges and calls range(first, end) for each, in parallel.
///
/// Uses the threads that the enclosing parallel_tasks() left free, or all threads outside of it. Results written to a
/// slot per index do not depend on the number of threads. A waiting thread takes up no other work, so that `range` may
/// use thread-local storage.
///
/// @param grain  smallest length of a range; shorter loops run on the calling thread
void parallel_ranges(int count, int grain, const std::function<void(int, int)>& range);

/// Number of hardware threads, at least 1.
int hardware_threads();

}  // namespace myo
