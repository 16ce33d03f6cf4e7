#pragma once

#include <functional>
#include <memory>

namespace myo {

/// Runs work that cannot be interrupted, such as an ordering by a library, so that its caller can leave.
///
/// Outside of a CancellationScope the work runs on the calling thread. Inside, it runs on a thread of its own; if
/// cancellation is requested meanwhile, the caller returns at once, and the work ends by itself later and is dropped.
/// So the work must own what it reads and writes, for example through shared pointers.
/// @return  false if the work was abandoned
/// Errors: an exception of the work is rethrown, unless it was abandoned.
bool run_abandonable(const std::function<void()>& work);

/// Number of abandoned calls that still run. A program that ends must not destroy what they use: see leave() in the
/// program's main file.
int abandoned_calls();

}  // namespace myo
