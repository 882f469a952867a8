// Owners of SDL's video, of one of its windows, surfaces and GL contexts.
#pragma once

#include <SDL.h>

#include <memory>

#include "screen/painter.h"
#include "screen/window.h"

namespace screen {

// SDL's video, started on a real display. Throws std::runtime_error when there is none.
class Display {
public:
    Display();
    ~Display();
    Display(Display const&) = delete;
    Display& operator=(Display const&) = delete;
};

struct DestroyWindow {
    void operator()(SDL_Window* window) const { SDL_DestroyWindow(window); }
};
using SdlWindow = std::unique_ptr<SDL_Window, DestroyWindow>;

struct FreeSurface {
    void operator()(SDL_Surface* surface) const { SDL_FreeSurface(surface); }
};
using SdlSurface = std::unique_ptr<SDL_Surface, FreeSurface>;

// Flags of SDL's besides those that every window of ours has. Throws std::runtime_error.
SdlWindow open_window(WindowSettings const& settings, Uint32 flags);

// What the next window with SDL_WINDOW_OPENGL is to offer.
void ask_for_gl();
GlFunction find_gl_function(char const* name);

// A context in a window, current while it lives.
class GlContext {
public:
    explicit GlContext(SDL_Window* window);
    ~GlContext();
    GlContext(GlContext const&) = delete;
    GlContext& operator=(GlContext const&) = delete;

private:
    SDL_Window* window_;
    SDL_GLContext context_;
};

}  // namespace screen
