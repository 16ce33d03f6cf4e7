#pragma once

#include <atomic>

namespace myo::app {

/// From now on SIGINT and SIGTERM set interrupt_flag(); a second signal ends the program at once.
void catch_interrupts();

/// True after the user asked to stop.
std::atomic<bool>& interrupt_flag();

}  // namespace myo::app
