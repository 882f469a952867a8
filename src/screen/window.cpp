#include "screen/window.h"

#include <SDL.h>

#include <algorithm>
#include <chrono>
#include <future>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "screen/gl_table.h"
#include "screen/graphics_card.h"
#include "screen/heap.h"
#include "screen/offscreen.h"
#include "screen/plain_painter.h"
#include "screen/window_parts.h"

namespace screen {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double usual_refresh_rate = 60;  // Hz, where the display does not say

bool is_software(std::string_view renderer) {
    for (char const* name : {"llvmpipe", "softpipe", "swrast", "Software Rasterizer", "GDI Generic"})
        if (renderer.find(name) != std::string_view::npos) return true;
    return false;
}

// Paints the picture once, so that the programs for what is in it are compiled.
Offscreen offscreen_for(view::Picture const& picture) {
    prepare_heap_of_thread();
    Offscreen offscreen(ChannelOrder::bgra);
    offscreen.paint(picture);
    return offscreen;
}

}  // namespace

struct Window::Body {
    Display display;
    SdlWindow window;
    std::optional<GlContext> gl;
    std::optional<Painter> painter;      // in gl
    std::optional<Offscreen> offscreen;  // where there is no gl
    std::optional<PlainPainter> plain;   // until that is there
    std::future<Offscreen> coming;       // made by another thread, since OSMesa takes long to load, with its compiler
    bool is_shown = false;
    std::string renderer_name;
    Clock::time_point shown = Clock::now();

    explicit Body(WindowSettings const& settings) {
        if (settings.renderer == Renderer::software || !start_gl(settings)) start_software(settings);
    }

    bool start_gl(WindowSettings const& settings);
    void start_software(WindowSettings const& settings);
    Pixels const& painted(view::Picture const& picture);
    void show_software(view::Picture const& picture);
    Extent extent() const;
    double refresh_rate() const;
    void wait_for_turn();
};

// Without a graphics card OpenGL would be Mesa's software too, at the price of one more copy: then OSMesa is used.
bool Window::Body::start_gl(WindowSettings const& settings) {
    bool const wanted = settings.renderer == Renderer::gl;
    if (!wanted && !may_have_graphics_card()) return false;
    try {
        ask_for_gl();
        window = open_window(settings, SDL_WINDOW_OPENGL);
        gl.emplace(window.get());
        GladGLContext const table = gl_table(find_gl_function);
        std::string const name = reinterpret_cast<char const*>(table.GetString(GL_RENDERER));
        if (!wanted && is_software(name)) throw std::runtime_error("OpenGL here is software");
        painter.emplace(find_gl_function);
        SDL_GL_SetSwapInterval(1);
        renderer_name = "OpenGL, " + name;
        return true;
    } catch (std::runtime_error const&) {
        if (wanted) throw;
        painter.reset();
        gl.reset();
        window.reset();
        return false;
    }
}

void Window::Body::start_software(WindowSettings const& settings) {
    // SDL would show a surface through OpenGL, which shares its idea of the current context with OSMesa.
    SDL_SetHint(SDL_HINT_FRAMEBUFFER_ACCELERATION, "0");
    window = open_window(settings, 0);
    // Who asks for it by name has it from the first picture on.
    if (settings.renderer == Renderer::software) {
        offscreen.emplace(ChannelOrder::bgra);
    } else {
        prepare_offscreen();
        plain.emplace(ChannelOrder::bgra);
    }
    renderer_name = "software, OSMesa";
}

Extent Window::Body::extent() const {
    Extent extent;
    if (gl)
        SDL_GL_GetDrawableSize(window.get(), &extent.width, &extent.height);
    else
        SDL_GetWindowSizeInPixels(window.get(), &extent.width, &extent.height);
    return {std::max(1, extent.width), std::max(1, extent.height)};
}

double Window::Body::refresh_rate() const {
    SDL_DisplayMode mode{};
    int const index = SDL_GetWindowDisplayIndex(window.get());
    bool const told = index >= 0 && SDL_GetCurrentDisplayMode(index, &mode) == 0 && mode.refresh_rate > 0;
    return told ? mode.refresh_rate : usual_refresh_rate;
}

Pixels const& Window::Body::painted(view::Picture const& picture) {
    if (coming.valid() && coming.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
        offscreen.emplace(coming.get());
        plain.reset();
    }
    return offscreen ? offscreen->paint(picture) : plain->paint(picture);
}

void Window::Body::show_software(view::Picture const& picture) {
    Pixels const& pixels = painted(picture);
    auto* const bytes = const_cast<std::uint8_t*>(pixels.rgba.data());
    SdlSurface const image(SDL_CreateRGBSurfaceWithFormatFrom(bytes, pixels.width, pixels.height, 32, 4 * pixels.width,
                                                              SDL_PIXELFORMAT_BGRA32));
    SDL_Surface* const surface = SDL_GetWindowSurface(window.get());
    if (!image || !surface) throw std::runtime_error(std::string("the window cannot be painted: ") + SDL_GetError());
    SDL_SetSurfaceBlendMode(image.get(), SDL_BLENDMODE_NONE);
    // The window may have been resized since the picture was laid out: the next one will fit.
    bool const fits = surface->w == pixels.width && surface->h == pixels.height;
    int const blitted = fits ? SDL_BlitSurface(image.get(), nullptr, surface, nullptr)
                             : SDL_BlitScaled(image.get(), nullptr, surface, nullptr);
    if (blitted == 0) SDL_UpdateWindowSurface(window.get());
    // From the second picture on: while a library is being loaded no other can be, and after the first one sound and
    // gamepads are.
    if (plain && std::exchange(is_shown, true) && !coming.valid())
        coming = std::async(std::launch::async, offscreen_for, picture);
}

// Where the display does not make us wait, the clock does.
void Window::Body::wait_for_turn() {
    using Seconds = std::chrono::duration<double>;
    double const left = 1 / refresh_rate() - Seconds(Clock::now() - shown).count();
    constexpr double worth_a_wait = 1e-3;  // s
    if (left > worth_a_wait) SDL_Delay(static_cast<Uint32>(left * 1000));
    shown = Clock::now();
}

Window::Window(WindowSettings const& settings) : body_(std::make_unique<Body>(settings)) {}
Window::~Window() = default;
Window::Window(Window&&) noexcept = default;
Window& Window::operator=(Window&&) noexcept = default;

Extent Window::extent() const { return body_->extent(); }

double Window::pixel_ratio() const {
    int width = 0, height = 0;
    SDL_GetWindowSize(body_->window.get(), &width, &height);
    return width > 0 ? static_cast<double>(extent().width) / width : 1;
}

double Window::refresh_rate() const { return body_->refresh_rate(); }

void Window::present(view::Picture const& picture) {
    if (body_->gl) {
        Extent const extent = body_->extent();
        body_->painter->paint(picture);
        body_->painter->show(extent.width, extent.height);
        SDL_GL_SwapWindow(body_->window.get());
    } else {
        body_->show_software(picture);
    }
    body_->wait_for_turn();
}

void Window::toggle_fullscreen() {
    SDL_Window* const window = body_->window.get();
    bool const full = SDL_GetWindowFlags(window) & SDL_WINDOW_FULLSCREEN_DESKTOP;
    SDL_SetWindowFullscreen(window, full ? 0 : SDL_WINDOW_FULLSCREEN_DESKTOP);
}

void Window::capture_pointer() { SDL_CaptureMouse(SDL_TRUE); }
void Window::release_pointer() { SDL_CaptureMouse(SDL_FALSE); }
void Window::retitle(std::string const& title) { SDL_SetWindowTitle(body_->window.get(), title.c_str()); }

bool Window::may_be_left() const {
    char const* const name = SDL_GetCurrentVideoDriver();
    std::string_view const driver = name ? name : "";
    return driver == "x11" || driver == "wayland";
}

bool Window::is_loading() const {
    std::future<Offscreen> const& coming = body_->coming;
    return coming.valid() && coming.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
}

std::string Window::renderer_name() const { return body_->renderer_name; }

}  // namespace screen
