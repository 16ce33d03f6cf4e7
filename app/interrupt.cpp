#include "interrupt.hpp"

#include <csignal>

namespace myo::app {
namespace {

// A signal handler can only reach global, lock-free state.
std::atomic<bool> stop{false};
static_assert(std::atomic<bool>::is_always_lock_free);

// Relaxed: the flag orders nothing else, it is only read again and again.
extern "C" void on_interrupt(int signal) {
    stop.store(true, std::memory_order_relaxed);
    // The default action of the next signal ends the program at once.
    std::signal(signal, SIG_DFL);
}

}  // namespace

void catch_interrupts() {
    std::signal(SIGINT, on_interrupt);
    std::signal(SIGTERM, on_interrupt);
}

std::atomic<bool>& interrupt_flag() { return stop; }

}  // namespace myo::app
