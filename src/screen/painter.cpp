#include "screen/painter.h"

#include <algorithm>
#include <cmath>

#include "screen/batch_renderer.h"
#include "screen/coverage.h"
#include "screen/grain.h"

namespace screen {
namespace {

double wrapped(double value, double period) { return value - period * std::floor(value / period); }

// The grain's place is taken modulo its tile, so that a far world origin costs no precision.
Quad area_quad(view::Paint const& paint) {
    Quad quad;
    quad.colour = floats(paint.top);
    quad.second_colour = floats(paint.bottom);
    double const tile = grain_metres * std::max(paint.grain_scale, 1e-3);  // pixels
    double const texels = grain_side / tile;                               // per pixel
    double const bottom = paint.bottom_y == paint.top_y ? paint.top_y + 1 : paint.bottom_y;
    double const across = geometry::dot(paint.grain_origin, geometry::turned_right(paint.down));
    double const below = geometry::dot(paint.grain_origin, paint.down);
    quad.more = {static_cast<float>(paint.down.x()), static_cast<float>(paint.down.y()), 0, 0};
    quad.place = {static_cast<float>(wrapped(across, tile)), static_cast<float>(wrapped(below, tile)),
                  static_cast<float>(1 / tile), static_cast<float>(std::max(0.0, std::log2(texels)))};
    quad.form = {static_cast<float>(paint.top_y), static_cast<float>(bottom), static_cast<float>(paint.grain), 0};
    return quad;
}

}  // namespace

struct Painter::Body {
    GladGLContext gl;
    BatchRenderer renderer;
    std::unique_ptr<Canvas> frame, backdrop;
    unsigned long long backdrop_key = 0;  // 0 = none is kept
    std::unique_ptr<Glyphs> glyphs;
    EdgeAtlas edges;  // of the areas that wait in the batch
    Batch batch;

    explicit Body(FindGlFunction find) : gl(gl_table(find)), renderer(gl) {}

    int width() const { return frame->width(); }
    int height() const { return frame->height(); }

    void resize(int width, int height);
    void paint(view::Picture const& picture);
    void paint_shapes(std::vector<view::Shape> const& shapes);
    void add(view::Sky const& sky) { add_shape(batch, sky, width(), height()); }
    void add(view::Area const& area);
    void add(view::Label const& label);
    int kept(EdgeTile const& tile);
    template <class Shape>
    void add(Shape const& shape) {
        add_shape(batch, shape);
    }
    Line line_of(view::Label label, double start);
    void flush();
};

void Painter::Body::resize(int width, int height) {
    require_paintable(width, height);
    if (frame && frame->width() == width && frame->height() == height) return;
    frame.reset();
    backdrop.reset();
    backdrop_key = 0;
    frame = std::make_unique<Canvas>(gl, width, height);
    renderer.fit(width, height);
}

void Painter::Body::paint(view::Picture const& picture) {
    resize(picture.width, picture.height);
    bool const keep = picture.backdrop_key != 0;
    if (keep && !backdrop) backdrop = std::make_unique<Canvas>(gl, picture.width, picture.height);
    if (!keep || picture.backdrop_key != backdrop_key) {
        if (keep) backdrop_key = 0;
        (keep ? backdrop : frame)->paint_here();
        gl.ClearColor(0, 0, 0, 1);
        gl.Clear(GL_COLOR_BUFFER_BIT);
        paint_shapes(picture.backdrop);
    }
    if (keep) {
        backdrop_key = picture.backdrop_key;
        frame->copy_from(*backdrop);
    }
    frame->paint_here();
    paint_shapes(picture.shapes);
}

void Painter::Body::paint_shapes(std::vector<view::Shape> const& shapes) {
    for (view::Shape const& shape : shapes) std::visit([this](auto const& it) { add(it); }, shape);
    flush();
}

void Painter::Body::add(view::Area const& area) {
    Coverage const covered = even_odd_coverage(area.rings, width(), height());
    view::Paint const& paint = area.paint;
    bool const grained = paint.grain > 0, opaque = paint.top.alpha >= 1 && paint.bottom.alpha >= 1;
    if (grained && !renderer.has_grain_for(paint.grain_scale)) {
        flush();
        renderer.choose_grain(paint.grain_scale);
    }
    Quad quad = area_quad(paint);
    for (Box const& box : covered.inside) {
        quad.corners = upright(box.left, box.top, box.right, box.bottom);
        batch.add(grained ? Program::grained_area : Program::smooth_area, quad,
                  opaque ? Blending::opaque : Blending::over);
    }
    for (EdgeTile const& tile : covered.edges) {
        quad.corners = upright(tile.left, tile.top, tile.left + tile_side, tile.top + tile_side);
        quad.form[3] = static_cast<float>(kept(tile));
        batch.add(grained ? Program::grained_edge : Program::smooth_edge, quad);
    }
}

int Painter::Body::kept(EdgeTile const& tile) {
    if (edges.is_full()) flush();
    return edges.add(tile);
}

// A text that does not fit an empty atlas is drawn smaller.
Line Painter::Body::line_of(view::Label label, double start) {
    for (;; label.height /= 2) {
        if (auto line = glyphs->line(label.text, label.height, label.weight, start)) return *line;
        flush();
        glyphs->clear();
        if (auto line = glyphs->line(label.text, label.height, label.weight, start)) return *line;
        if (label.height < 8) return {};
    }
}

void Painter::Body::add(view::Label const& label) {
    if (!glyphs) glyphs = std::make_unique<Glyphs>();
    double left = label.at.x();
    if (label.anchor != view::Anchor::Left) {
        double const width_of_text = glyphs->width_of(label.text, label.height, label.weight);
        left -= label.anchor == view::Anchor::Centre ? width_of_text / 2 : width_of_text;
    }
    // Letters stand on whole pixels up and down, which is sharpest, and on quarters sideways.
    double const base_x = std::floor(left), base_y = std::floor(label.at.y() + 0.5);
    if (!(std::abs(base_x) <= 1e6 && std::abs(base_y) <= 1e6)) return;
    for (auto const& [glyph, pen] : line_of(label, left - base_x).glyphs) {
        if (glyph.width == 0 || glyph.height == 0) continue;
        double const x = base_x + pen + glyph.left, y = base_y + glyph.top;
        Quad quad;
        quad.corners = upright(x, y, x + glyph.width, y + glyph.height);
        quad.colour = floats(label.colour);
        quad.place = {static_cast<float>(glyph.atlas_x - x), static_cast<float>(glyph.atlas_y - y), 0, 0};
        batch.add(Program::glyph, quad);
    }
}

void Painter::Body::flush() {
    if (!batch.is_empty()) renderer.draw(batch, edges, glyphs.get());
    batch.clear();
    edges.clear();
}

Painter::Painter(FindGlFunction find) : body_(std::make_unique<Body>(find)) {}
Painter::~Painter() = default;
Painter::Painter(Painter&&) noexcept = default;
Painter& Painter::operator=(Painter&&) noexcept = default;

void Painter::paint(view::Picture const& picture) { body_->paint(picture); }

void Painter::read_into(Pixels& pixels, ChannelOrder order) const {
    if (!body_->frame) return;
    pixels.width = body_->width();
    pixels.height = body_->height();
    pixels.rgba.resize(4 * static_cast<std::size_t>(pixels.width) * static_cast<std::size_t>(pixels.height));
    body_->frame->read_from_here();
    body_->gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
    body_->gl.ReadPixels(0, 0, pixels.width, pixels.height, order == ChannelOrder::rgba ? GL_RGBA : GL_BGRA,
                         GL_UNSIGNED_BYTE, pixels.rgba.data());
}

Pixels Painter::read(ChannelOrder order) const {
    Pixels pixels;
    read_into(pixels, order);
    return pixels;
}

void Painter::show(int width, int height) const {
    if (!body_->frame) return;
    auto const& gl = body_->gl;
    body_->frame->read_from_here();
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    bool const fits = width == body_->width() && height == body_->height();
    gl.BlitFramebuffer(0, 0, body_->width(), body_->height(), 0, height, width, 0, GL_COLOR_BUFFER_BIT,
                       fits ? GL_NEAREST : GL_LINEAR);
}

}  // namespace screen
