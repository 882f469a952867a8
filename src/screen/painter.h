// Paints pictures with OpenGL 3.3: owns the programs and textures of the context that was current when it was made.
#pragma once

#include <memory>

#include "screen/pixels.h"
#include "view/picture.h"

namespace screen {

// Finds a GL function by name, for the context that is current: OSMesaGetProcAddress, SDL_GL_GetProcAddress.
using GlFunction = void (*)();
using FindGlFunction = GlFunction (*)(char const* name);

enum class ChannelOrder { rgba, bgra };

// All calls need the painter's context to be current. A picture is painted into a frame of the painter's own, so that
// its bytes are the same off the screen and in a window, and whatever was painted before.
class Painter {
public:
    explicit Painter(FindGlFunction find);
    ~Painter();
    Painter(Painter&&) noexcept;
    Painter& operator=(Painter&&) noexcept;

    // Throws std::runtime_error when the picture's size cannot be painted, or a font is missing.
    void paint(view::Picture const& picture);

    // The frame that was painted last.
    Pixels read(ChannelOrder order) const;
    // The same without new memory where `pixels` has room already.
    void read_into(Pixels& pixels, ChannelOrder order) const;
    // Shows the frame in the context's own framebuffer of the given size, stretched where the sizes differ.
    void show(int width, int height) const;

private:
    struct Body;
    std::unique_ptr<Body> body_;
};

}  // namespace screen
