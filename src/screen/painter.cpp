#include "screen/painter.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "screen/batch_renderer.h"
#include "screen/coverage.h"
#include "screen/grain.h"
#include "screen/occlusion.h"

namespace screen {
namespace {

using geometry::Vec2;

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

constexpr int small_area = 60'000;  // pixels

int pixels_in(std::vector<Box> const& boxes) {
    int sum = 0;
    for (Box const& box : boxes) sum += (box.right - box.left) * (box.bottom - box.top);
    return sum;
}

bool is_opaque(view::Paint const& paint) { return paint.top.alpha >= 1 && paint.bottom.alpha >= 1; }

bool is_plain(view::Paint const& paint) { return paint.grain <= 0 && floats(paint.top) == floats(paint.bottom); }

// Pixels that a shape may touch; nothing where that is not worth knowing, or not finite.
std::optional<Box> bounds_of(view::Shape const& shape) {
    Vec2 low, high;
    double reach = 0;
    if (auto const* disc = std::get_if<view::Disc>(&shape)) {
        low = high = disc->centre;
        reach = disc->radius + std::max(disc->softness, 1.0);
    } else if (auto const* stroke = std::get_if<view::Stroke>(&shape)) {
        low = stroke->from.cwiseMin(stroke->to);
        high = stroke->from.cwiseMax(stroke->to);
        reach = std::max(stroke->width, 1.0) / 2;
    } else {
        return std::nullopt;
    }
    constexpr double margin = 2, far = 1e6;  // pixels
    low -= Vec2::Constant(reach + margin);
    high += Vec2::Constant(reach + margin);
    if (!(low.minCoeff() > -far && high.maxCoeff() < far)) return std::nullopt;
    return Box{static_cast<int>(std::floor(low.x())), static_cast<int>(std::floor(low.y())),
               static_cast<int>(std::ceil(high.x())), static_cast<int>(std::ceil(high.y()))};
}

// A shape's number in the order of painting, and what of it is seen.
struct Layer {
    int number;
    Coverage const& covered;  // of an area
    Occlusion const& occlusion;
};

}  // namespace

struct Painter::Body {
    GladGLContext gl;
    BatchRenderer renderer;
    std::unique_ptr<Canvas> frame, backdrop;
    unsigned long long backdrop_key = 0;  // 0 = none is kept
    unsigned long long asked_key = 0;     // of the picture before
    std::unique_ptr<Glyphs> glyphs;
    EdgeAtlas edges;  // of the areas that wait in the batch
    Batch batch;

    explicit Body(FindGlFunction find) : gl(gl_table(find)), renderer(gl) {}

    int width() const { return frame->width(); }
    int height() const { return frame->height(); }

    void resize(int width, int height);
    void paint(view::Picture const& picture);
    void paint_shapes(std::vector<view::Shape> const& shapes);
    void add(view::Sky const& sky, Layer const& layer);
    void add(view::Area const& area, Layer const& layer);
    void add(view::Label const& label, Layer const&);
    int kept(EdgeTile const& tile);
    template <class Shape>
    void add(Shape const& shape, Layer const&) {
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
    backdrop_key = asked_key = 0;
    frame = std::make_unique<Canvas>(gl, width, height);
    renderer.fit(width, height);
}

void Painter::Body::paint(view::Picture const& picture) {
    resize(picture.width, picture.height);
    // Kept is what is asked for twice in a row: while the camera moves, keeping would only cost a copy.
    bool const again = picture.backdrop_key != 0 && picture.backdrop_key == asked_key;
    asked_key = picture.backdrop_key;
    if (!again || picture.backdrop_key != backdrop_key) {
        if (again && !backdrop) backdrop = std::make_unique<Canvas>(gl, picture.width, picture.height);
        if (again) backdrop_key = 0;
        (again ? backdrop : frame)->paint_here();
        gl.ClearColor(0, 0, 0, 1);
        gl.Clear(GL_COLOR_BUFFER_BIT);
        paint_shapes(picture.backdrop);
    }
    if (again) {
        backdrop_key = picture.backdrop_key;
        frame->copy_from(*backdrop);
    }
    frame->paint_here();
    paint_shapes(picture.shapes);
}

void Painter::Body::paint_shapes(std::vector<view::Shape> const& shapes) {
    std::vector<Coverage> coverages(shapes.size());
    Occlusion occlusion(width(), height());
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        auto const* area = std::get_if<view::Area>(&shapes[i]);
        if (!area) continue;
        coverages[i] = coverage_of(area->rings, area->rule, width(), height());
        if (is_opaque(area->paint))
            for (Box const& box : coverages[i].inside) occlusion.cover(box, static_cast<int>(i));
    }
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        Layer const layer{static_cast<int>(i), coverages[i], occlusion};
        auto const bounds = bounds_of(shapes[i]);
        if (bounds && occlusion.hides(*bounds, layer.number)) continue;
        std::visit([&](auto const& it) { add(it, layer); }, shapes[i]);
    }
    flush();
}

void Painter::Body::add(view::Sky const& sky, Layer const& layer) {
    Box const whole{0, 0, (width() + tile_side - 1) / tile_side * tile_side,
                    (height() + tile_side - 1) / tile_side * tile_side};
    for (Box const& box : layer.occlusion.seen(whole, layer.number)) add_shape(batch, sky, box, height());
}

void Painter::Body::add(view::Area const& area, Layer const& layer) {
    view::Paint const& paint = area.paint;
    bool const grained = paint.grain > 0;
    if (grained && !renderer.has_grain_for(paint.grain_scale)) {
        flush();
        renderer.choose_grain(paint.grain_scale);
    }
    Quad quad = area_quad(paint);
    std::vector<Box> seen;
    for (Box const& inside : layer.covered.inside)
        for (Box const& box : layer.occlusion.seen(inside, layer.number)) seen.push_back(box);
    Program const inner = grained           ? Program::grained_area
                          : is_plain(paint) ? Program::plain_area
                                            : Program::smooth_area;
    Program const edge = grained ? Program::grained_edge : Program::smooth_edge;
    // One program for all of what is small: changing it costs more than looking up that a pixel is inside.
    bool const small = pixels_in(seen) < small_area;
    quad.form[3] = EdgeAtlas::full;
    for (Box const& box : seen) {
        quad.corners = upright(box.left, box.top, box.right, box.bottom);
        batch.add(small ? edge : inner, quad, is_opaque(paint) && !small ? Blending::opaque : Blending::over);
    }
    for (EdgeTile const& tile : layer.covered.edges) {
        Box const box{tile.left, tile.top, tile.left + tile_side, tile.top + tile_side};
        if (layer.occlusion.hides(box, layer.number)) continue;
        Box const part = seen_part_of(tile);
        quad.corners = upright(part.left, part.top, part.right, part.bottom);
        quad.form[3] = static_cast<float>(kept(tile));
        batch.add(edge, quad);
    }
}

int Painter::Body::kept(EdgeTile const& tile) {
    if (edges.is_full()) flush();
    return edges.add(tile);
}

// A text that does not fit an empty atlas is drawn smaller.
Line Painter::Body::line_of(view::Label label, double start) {
    for (;; label.height /= 2, label.swell /= 2) {
        if (auto line = glyphs->line(label, start)) return *line;
        flush();
        glyphs->clear();
        if (auto line = glyphs->line(label, start)) return *line;
        if (label.height < 8) return {};
    }
}

void Painter::Body::add(view::Label const& label, Layer const&) {
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
