#pragma once

#include <atomic>

namespace myo::app {

/// From now on SIGINT and SIGTERM set interrupt_flag(); a second signal of the kind ends the program at once.
void catch_interrupts();

/// True after the user asked to stop. Lives as long as the program and may be read from any thread.
std::atomic<bool>& interrupt_flag();

}  // namespace myo::app
