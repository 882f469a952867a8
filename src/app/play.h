// smb2d play: the window, and the loop that listens, lets time pass and draws.
#pragma once

#include <string>

#include "app/options.h"

namespace app {

struct PlayOptions {
    std::string file;  // a level or a run; empty = the first level
    MethodOptions method;
    std::string renderer = "auto", size = "1280x720";
    std::string ghost;  // a run that rolls along; empty = none
    bool fullscreen = false;
    bool no_sound = false;
    bool no_turn = false;  // of the picture, as the stage is tilted
};

// The exit status. Throws UsageError, Interrupted, std::runtime_error, the last also where there is no display.
int play(PlayOptions const& options);

}  // namespace app
