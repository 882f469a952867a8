// The window on a display: owns the SDL window and what paints in it, OpenGL or OSMesa.
#pragma once

#include <memory>
#include <string>

#include "view/picture.h"

namespace screen {

enum class Renderer {
    automatic,  // OpenGL if a graphics card does it, else plain loops until there is software
    gl,
    software  // OSMesa's pixels shown in a plain window
};

struct WindowSettings {
    std::string title = "smb2d";
    int width = 1280, height = 720;  // in the units of the pointer, which may be larger than a pixel
    Renderer renderer = Renderer::automatic;
};

struct Extent {
    int width = 0, height = 0;  // pixels
};

// The owner of SDL's video while it lives: one at a time, on the main thread. Throws std::runtime_error, for instance
// when there is no display. Events are taken with SDL_PollEvent while it lives; pointer coordinates of events times
// pixel_ratio are pixels of the picture.
class Window {
public:
    explicit Window(WindowSettings const& settings);
    ~Window();
    Window(Window&&) noexcept;
    Window& operator=(Window&&) noexcept;

    // What a picture should measure to fit now: ask before each one, the window may have been resized.
    Extent extent() const;
    double pixel_ratio() const;   // pixels per unit of pointer coordinates
    double refresh_rate() const;  // Hz, of the display that the window is on

    // Paints and shows; returns at most refresh_rate times a second, by waiting.
    void present(view::Picture const& picture);

    void toggle_fullscreen();
    // While captured, the pointer is followed outside of the window too: between press and release of a drag.
    void capture_pointer();
    void release_pointer();
    void retitle(std::string const& title);

    // What paints, in words: "OpenGL, NVIDIA ..." or "software, llvmpipe ...".
    std::string renderer_name() const;

    // Whether the display takes the window back by itself when the program ends, as X and Wayland do.
    bool may_be_left() const;
    // Whether another thread still loads what paints: the destructor waits for it.
    bool is_loading() const;

private:
    struct Body;
    std::unique_ptr<Body> body_;
};

}  // namespace screen
