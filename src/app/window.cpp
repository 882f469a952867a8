// The options of smb2d play; what happens in the window is in play.cpp.
#include <memory>

#include "app/command.h"
#include "app/play.h"

namespace app {

Command play_command(CLI::App& program) {
    auto const options = std::make_shared<PlayOptions>();
    CLI::App* const command = program.add_subcommand("play", "The window: roll the ball with the mouse (the default)");
    command->add_option("file", options->file, "a level (.svg) or a run (.json); default: the first level")
        ->type_name("LEVEL|RUN");
    declare(*command, options->method);
    command->add_option("--renderer", options->renderer, "auto, gl or software (default: auto)")->type_name("NAME");
    command->add_option("-s,--size", options->size, "of the window, pixels (default: 1280x720)")->type_name("WxH");
    command->add_flag("--fullscreen", options->fullscreen, "the whole screen");
    command->footer("F1 shows the keys. Example: smb2d play assets/levels/01-sunny-hills.svg");
    return {command, [options] { return play(*options); }};
}

}  // namespace app
