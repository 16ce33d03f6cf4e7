#include "interrupt.hpp"

#include <csignal>
#include <cstdlib>
#include <thread>

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

sigset_t termination() {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGTERM);
    return set;
}

// METIS, which orders the unknowns, puts a handler of its own in the place of any other while it runs, in whichever
// thread; it jumps to where only METIS's thread can go (GKlib, error.c: gk_sigtrap). A signal that every thread blocks
// and one thread waits for never reaches a handler. Libraries start threads before main() (OpenBLAS), and threads
// inherit what is blocked: hence in .preinit_array, the functions that run first.
void block_termination(int /*argc*/, char** /*argv*/, char** /*environment*/) {
    const sigset_t set = termination();
    pthread_sigmask(SIG_BLOCK, &set, nullptr);
}
[[gnu::section(".preinit_array"), gnu::used]] void (*const before_libraries)(int, char**, char**) = &block_termination;

/// The handler of SIGTERM, as a thread: the second signal ends the program.
[[noreturn]] void wait_for_termination() {
    const sigset_t set = termination();
    int signal = 0;
    sigwait(&set, &signal);
    stop.store(true, std::memory_order_relaxed);
    sigwait(&set, &signal);
    take_terminations_again();
    raise(SIGTERM);
    std::_Exit(128 + SIGTERM);
}

}  // namespace

void take_terminations_again() {
    std::signal(SIGTERM, SIG_DFL);
    const sigset_t set = termination();
    pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

void catch_interrupts() {
    std::signal(SIGINT, on_interrupt);
    // Whoever started the program may have told it to ignore the signal; then none would arrive.
    std::signal(SIGTERM, on_interrupt);
    std::thread(wait_for_termination).detach();
}

std::atomic<bool>& interrupt_flag() { return stop; }

}  // namespace myo::app
