#include "screen/offscreen.h"

#include <array>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <utility>

#include "screen/heap.h"
#include "screen/mesa.h"

namespace screen {

// Painting on the calling thread alone gives the most pictures a second when each thread has a context of its own.
// Mesa looks at this once, at its first context.
void prepare_offscreen() {
    static std::once_flag once;
    std::call_once(once, [] {
        setenv("LP_NUM_THREADS", "0", 0);
        prepare_heap();
    });
}

namespace {

OSMesaContext new_context() {
    prepare_offscreen();
    std::array<int, 11> const wanted{OSMESA_FORMAT,
                                     OSMESA_RGBA,
                                     OSMESA_PROFILE,
                                     OSMESA_CORE_PROFILE,
                                     OSMESA_CONTEXT_MAJOR_VERSION,
                                     3,
                                     OSMESA_CONTEXT_MINOR_VERSION,
                                     3,
                                     OSMESA_DEPTH_BITS,
                                     0,
                                     0};
    if (OSMesaContext const context = mesa().create_context(wanted.data(), nullptr)) return context;
    throw std::runtime_error("Mesa's software OpenGL 3.3 (OSMesa) cannot be started");
}

GlFunction find_function(char const* name) { return mesa().function_called(name); }

}  // namespace

struct Offscreen::Body {
    // The painter has a frame of its own; a context cannot be used without some framebuffer.
    std::array<std::uint8_t, 64> unused{};
    OSMesaContext context = new_context();
    ChannelOrder order;
    std::optional<Painter> painter;
    Pixels pixels;

    explicit Body(ChannelOrder wanted) : order(wanted) {
        try {
            make_current();
            painter.emplace(find_function);
        } catch (...) {
            mesa().destroy_context(context);
            throw;
        }
    }
    ~Body() {
        if (mesa().make_current(context, unused.data(), GL_UNSIGNED_BYTE, 4, 4)) painter.reset();
        mesa().make_current(nullptr, nullptr, 0, 0, 0);
        mesa().destroy_context(context);
    }

    void make_current() {
        if (mesa().make_current(context, unused.data(), GL_UNSIGNED_BYTE, 4, 4)) return;
        throw std::runtime_error("Mesa's software OpenGL (OSMesa) cannot be used on this thread");
    }
};

Offscreen::Offscreen(ChannelOrder order) : body_(std::make_unique<Body>(order)) {}
Offscreen::~Offscreen() = default;
Offscreen::Offscreen(Offscreen&&) noexcept = default;
Offscreen& Offscreen::operator=(Offscreen&&) noexcept = default;

Pixels const& Offscreen::paint(view::Picture const& picture) {
    body_->make_current();
    body_->painter->paint(picture);
    body_->painter->read_into(body_->pixels, body_->order);
    // Another owner of a context may work on this thread, and so may this context on another one.
    mesa().make_current(nullptr, nullptr, 0, 0, 0);
    return body_->pixels;
}

}  // namespace screen
