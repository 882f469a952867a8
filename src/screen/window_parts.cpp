#include "screen/window_parts.h"

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>

namespace screen {
namespace {

std::runtime_error failure(std::string const& what) { return std::runtime_error(what + ": " + SDL_GetError()); }

std::runtime_error no_display() {
    return std::runtime_error("no display to open a window on: neither DISPLAY nor WAYLAND_DISPLAY leads to one");
}

}  // namespace

Display::Display() {
    // Our own handling of SIGINT and SIGTERM stays in place.
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    // Without the folder of Wayland's socket its library would complain on our stderr; SDL_VIDEODRIVER still wins.
    bool const in_session = std::getenv("XDG_RUNTIME_DIR") != nullptr;
    if (!in_session) SDL_SetHint(SDL_HINT_VIDEODRIVER, "x11,kmsdrm");
    // Outside of a session SDL's search for a message bus would start one, which takes longer than all the rest.
    if (!in_session) setenv("DBUS_SESSION_BUS_ADDRESS", "disabled:", 0);
    // Nothing is written in words: X need not read how all of Unicode is composed.
    setenv("XCOMPOSEFILE", "/dev/null", 0);
    if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) throw no_display();
    // Without a display SDL may pick a driver that shows nothing.
    char const* const name = SDL_GetCurrentVideoDriver();
    std::string const driver = name ? name : "none";
    if (driver == "offscreen" || driver == "dummy" || driver == "evdev" || driver == "none") {
        SDL_QuitSubSystem(SDL_INIT_VIDEO);
        throw no_display();
    }
}

Display::~Display() { SDL_QuitSubSystem(SDL_INIT_VIDEO); }

SdlWindow open_window(WindowSettings const& settings, Uint32 flags) {
    SdlWindow window(SDL_CreateWindow(settings.title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED,
                                      settings.width, settings.height,
                                      flags | SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI));
    if (!window) throw failure("a window cannot be opened");
    constexpr int least_width = 320, least_height = 180;
    SDL_SetWindowMinimumSize(window.get(), least_width, least_height);
    return window;
}

void ask_for_gl() {
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 0);
}

GlFunction find_gl_function(char const* name) { return reinterpret_cast<GlFunction>(SDL_GL_GetProcAddress(name)); }

GlContext::GlContext(SDL_Window* window) : window_(window), context_(SDL_GL_CreateContext(window)) {
    if (!context_) throw failure("OpenGL 3.3 cannot be started");
}

GlContext::~GlContext() {
    SDL_GL_MakeCurrent(window_, nullptr);
    SDL_GL_DeleteContext(context_);
}

}  // namespace screen
