// smb2d play: the options of the window; what happens in it is in play.cpp.
#include <memory>

#include "app/command.h"

namespace app {

Command play_command(CLI::App& program) {
    CLI::App* const command = program.add_subcommand("play", "The window: roll the ball with the mouse");
    return {command, []() -> int { throw std::runtime_error("the window is not built yet"); }};
}

}  // namespace app
