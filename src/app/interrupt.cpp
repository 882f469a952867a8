#include "app/interrupt.h"

#include <pthread.h>

#include <csignal>

namespace app {

namespace {

// The only state that a signal handler may touch.
volatile std::sig_atomic_t interrupted = 0;

void note_interrupt(int) { interrupted = 1; }

}  // namespace

void watch_for_interrupts() {
    struct sigaction action {};
    action.sa_handler = note_interrupt;
    // No SA_RESTART: a write to a pipe that nobody reads must not outlast Ctrl-C.
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    std::signal(SIGPIPE, SIG_IGN);
}

bool is_interrupted() { return interrupted != 0; }

void leave_interrupts_to_the_main_thread() {
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    sigaddset(&signals, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
}

void stop_if_interrupted() {
    if (is_interrupted()) throw Interrupted();
}

}  // namespace app
