#pragma once

#include <atomic>

namespace myo::app {

/// From now on SIGINT and SIGTERM set interrupt_flag(); a second signal of the kind ends the program at once.
/// Before, SIGTERM waits.
void catch_interrupts();

/// SIGTERM ends the calling thread's program at once, as it ends one that catches nothing: for a child made by fork(),
/// which has none of the threads that wait for signals.
void take_terminations_again();

/// True after the user asked to stop. Lives as long as the program and may be read from any thread.
std::atomic<bool>& interrupt_flag();

}  // namespace myo::app
