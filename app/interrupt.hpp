#pragma once

#include <atomic>

namespace myo::app {

/// From now on Ctrl-C (and a polite kill) sets interrupt_flag(); a second one ends the program at once.
void catch_interrupts();

/// True once the user asked to stop.
std::atomic<bool>& interrupt_flag();

}  // namespace myo::app
