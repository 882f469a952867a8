// Subcommands: each declares its options on the command line and says what to do once they are read.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

#include "app/command_line.h"

namespace app {

// The exit statuses of docs/command-line.md.
inline constexpr int done = 0;
inline constexpr int failed = 1;
inline constexpr int wrong_usage = 2;
inline constexpr int fault_found = 3;
inline constexpr int was_interrupted = 130;

// What the user typed cannot be meant.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct Command {
    Subcommand options;
    std::function<int()> run;  // the exit status; throws UsageError, Interrupted, std::exception
};

Command play_command(CommandLine& program);
Command render_command(CommandLine& program);
Command record_command(CommandLine& program);
Command simulate_command(CommandLine& program);
Command check_command(CommandLine& program);
Command verify_command(CommandLine& program);
Command levels_command(CommandLine& program);

}  // namespace app
