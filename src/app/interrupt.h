// Ctrl-C and its like: noted by a signal handler, asked for by the loops.
#pragma once

#include <exception>
#include <string>
#include <utility>

namespace app {

// From here on SIGINT and SIGTERM are noted, a second one ends the program at once, and SIGPIPE is ignored.
void watch_for_interrupts();

bool is_interrupted();

// For other threads than the main one: their reads and writes are then not broken off by the signals.
void leave_interrupts_to_the_main_thread();

class Interrupted : public std::exception {
public:
    explicit Interrupted(std::string what = "interrupted") : what_(std::move(what)) {}
    char const* what() const noexcept override { return what_.c_str(); }

private:
    std::string what_;
};

// Throws Interrupted when the program has been asked to stop.
void stop_if_interrupted();

}  // namespace app
