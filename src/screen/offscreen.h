// Painting without a display: owns an OSMesa context and the painter in it.
#pragma once

#include <memory>

#include "screen/painter.h"
#include "screen/pixels.h"
#include "view/picture.h"

namespace screen {

// Sets what the process needs before its first context. Called before a thread makes one while others run: it changes
// the environment.
void prepare_offscreen();

// One for each thread gives the most pictures a second. May be made, used and destroyed on different threads, by one
// at a time. Throws std::runtime_error when there is no software OpenGL 3.3.
class Offscreen {
public:
    explicit Offscreen(ChannelOrder order = ChannelOrder::rgba);
    ~Offscreen();
    Offscreen(Offscreen&&) noexcept;
    Offscreen& operator=(Offscreen&&) noexcept;

    // The pixels stay valid until the next call. The picture gives the size; see require_paintable.
    Pixels const& paint(view::Picture const& picture);

private:
    struct Body;
    std::unique_ptr<Body> body_;
};

}  // namespace screen
