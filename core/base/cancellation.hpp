#pragma once

#include "base/progress.hpp"

namespace myo {

/// Lets what runs on this thread see the cancellation of its task without a Progress of its own: factorisations and
/// iterations deep below, whose interfaces speak of matrices. parallel_tasks() and parallel_ranges() pass it on to
/// their threads. Scopes nest.
class CancellationScope {
public:
    /// @param progress  of the task; null: none, as at the start of a thread. It must outlive the scope
    explicit CancellationScope(const Progress* progress);
    ~CancellationScope();
    CancellationScope(const CancellationScope&) = delete;
    CancellationScope& operator=(const CancellationScope&) = delete;

private:
    const Progress* before_;
};

/// Progress of the innermost scope on this thread, or null.
const Progress* cancellation_in_scope();

/// Whether the task of the innermost scope is to stop; false outside of all scopes. What then returns early gives an
/// incomplete result, which the task drops when it asks its own Progress.
bool cancellation_requested();

}  // namespace myo
