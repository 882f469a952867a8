#include "screen/painter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "screen/coverage.h"
#include "screen/gl_objects.h"
#include "screen/glyphs.h"
#include "screen/grain.h"
#include "screen/shaders.h"
#include "screen/shape_batch.h"

namespace screen {
namespace {

constexpr int coverage_unit = 0, grain_unit = 1, atlas_unit = 2;

constexpr int edge_tiles_across = 64;
constexpr int edge_atlas_side = edge_tiles_across * tile_side;  // texels

std::string fragment_source(Program program) {
    std::string const head = shaders::fragment_head, area = head + shaders::area;
    switch (program) {
        case Program::disc:
            return head + shaders::disc;
        case Program::box:
            return head + shaders::box;
        case Program::arc:
            return head + shaders::arc;
        case Program::smooth_area:
            return area + shaders::smooth_area;
        case Program::smooth_edge:
            return area + shaders::smooth_edge;
        case Program::grained_area:
            return area + shaders::grained_area;
        case Program::grained_edge:
            return area + shaders::grained_edge;
        case Program::glyph:
            return head + shaders::glyph;
        case Program::shell:
            break;
    }
    return head + shaders::shell;
}

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

std::unique_ptr<Texture> grain_texture(GladGLContext const& gl) {
    auto grain = std::make_unique<Texture>(gl, GL_R8, grain_side, grain_side, Sampling::tiled);
    std::vector<std::uint8_t> texels = grain_tile();
    // The renderer's own way to halve textures costs several times the first picture.
    for (int level = 0, side = grain_side; side >= 1; ++level, side /= 2) {
        grain->add_level(level, side, side, texels.data());
        texels = halved(texels, side);
    }
    return grain;
}

}  // namespace

struct Painter::Body {
    GladGLContext gl;
    GLuint records = 0, layout = 0;  // a buffer and how the shaders read it
    std::array<std::unique_ptr<GlProgram>, program_count> programs;
    std::unique_ptr<Canvas> frame, backdrop;
    unsigned long long backdrop_key = 0;  // 0 = none is kept
    std::unique_ptr<Texture> coverage, grain, atlas;
    std::optional<bool> grain_blended;
    std::unique_ptr<Glyphs> glyphs;
    std::vector<std::uint8_t> edge_atlas;
    int edge_tiles = 0;  // in the atlas, of the areas that wait in the batch
    Batch batch;

    explicit Body(FindGlFunction find) : gl(gl_table(find)) {
        gl.GenBuffers(1, &records);
        gl.GenVertexArrays(1, &layout);
    }
    ~Body() {
        gl.DeleteBuffers(1, &records);
        gl.DeleteVertexArrays(1, &layout);
    }

    int width() const { return frame->width(); }
    int height() const { return frame->height(); }

    void resize(int width, int height);
    void paint(view::Picture const& picture);
    void paint_shapes(std::vector<view::Shape> const& shapes);
    void add(view::Sky const& sky) { add_shape(batch, sky, width(), height()); }
    void add(view::Area const& area);
    void add(view::Label const& label);
    void choose_grain(double pixels_per_metre);
    int kept(EdgeTile const& tile);
    template <class Shape>
    void add(Shape const& shape) {
        add_shape(batch, shape);
    }
    Line line_of(view::Label label, double start);
    GlProgram const& program(Program which);
    void flush();
    void point_at(int first_quad);
};

void Painter::Body::resize(int width, int height) {
    require_paintable(width, height);
    if (frame && frame->width() == width && frame->height() == height) return;
    frame.reset();
    backdrop.reset();
    backdrop_key = 0;
    frame = std::make_unique<Canvas>(gl, width, height);
    for (auto& made : programs) made.reset();
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
    gl.Disable(GL_DEPTH_TEST);
    gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    batch.clear();
    for (view::Shape const& shape : shapes) std::visit([this](auto const& it) { add(it); }, shape);
    flush();
}

void Painter::Body::add(view::Area const& area) {
    Coverage const covered = even_odd_coverage(area.rings, width(), height());
    view::Paint const& paint = area.paint;
    bool const grained = paint.grain > 0, opaque = paint.top.alpha >= 1 && paint.bottom.alpha >= 1;
    if (grained) choose_grain(paint.grain_scale);
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

// Magnified texels are blended, for else they would be seen as squares.
void Painter::Body::choose_grain(double pixels_per_metre) {
    if (!grain) grain = grain_texture(gl);
    constexpr double slightly = 1.1;
    bool const wanted = pixels_per_metre > slightly * grain_side / grain_metres;
    if (grain_blended == wanted) return;
    flush();
    wanted ? grain->blend_texels() : grain->take_nearest_texels();
    grain_blended = wanted;
}

// The tile's number in the atlas until the next flush.
int Painter::Body::kept(EdgeTile const& tile) {
    if (edge_tiles == edge_tiles_across * edge_tiles_across) flush();
    edge_atlas.resize(static_cast<std::size_t>(edge_atlas_side) * edge_atlas_side);
    int const number = edge_tiles++;
    int const left = number % edge_tiles_across * tile_side, top = number / edge_tiles_across * tile_side;
    for (int row = 0; row < tile_side; ++row)
        std::copy_n(tile.values.begin() + row * tile_side, tile_side,
                    edge_atlas.begin() + (top + row) * edge_atlas_side + left);
    return number;
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

GlProgram const& Painter::Body::program(Program which) {
    auto& made = programs[static_cast<std::size_t>(which)];
    if (made) {
        made->use();
        return *made;
    }
    made = std::make_unique<GlProgram>(gl, shaders::vertex, fragment_source(which));
    made->use();
    made->set("frame_size", static_cast<float>(width()), static_cast<float>(height()));
    made->set_unit("coverage", coverage_unit);
    made->set_unit("grain", grain_unit);
    made->set_unit("atlas", atlas_unit);
    return *made;
}

void Painter::Body::flush() {
    if (batch.is_empty()) return;
    if (glyphs && glyphs->is_changed()) {
        if (!atlas) atlas = std::make_unique<Texture>(gl, GL_R8, atlas_side, atlas_side, Sampling::exact);
        atlas->upload(0, 0, atlas_side, atlas_side, glyphs->atlas().data());
        glyphs->mark_seen();
    }
    if (edge_tiles > 0) {
        if (!coverage)
            coverage = std::make_unique<Texture>(gl, GL_R8, edge_atlas_side, edge_atlas_side, Sampling::exact);
        int const rows = (edge_tiles + edge_tiles_across - 1) / edge_tiles_across * tile_side;
        coverage->upload(0, 0, edge_atlas_side, rows, edge_atlas.data());
        edge_tiles = 0;
    }
    if (coverage) coverage->bind(coverage_unit);
    if (grain) grain->bind(grain_unit);
    if (atlas) atlas->bind(atlas_unit);
    gl.BindVertexArray(layout);
    gl.BindBuffer(GL_ARRAY_BUFFER, records);
    auto const size = static_cast<GLsizeiptr>(batch.quads.size() * sizeof(Quad));
    gl.BufferData(GL_ARRAY_BUFFER, size, batch.quads.data(), GL_STREAM_DRAW);
    for (Run const& run : batch.runs) {
        program(run.program).use();
        if (run.blending == Blending::over)
            gl.Enable(GL_BLEND);
        else
            gl.Disable(GL_BLEND);
        point_at(run.first);
        gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, run.count);
    }
    batch.clear();
}

void Painter::Body::point_at(int first_quad) {
    constexpr GLuint vectors = sizeof(Quad) / sizeof(float[4]);
    auto const start = static_cast<std::uintptr_t>(first_quad) * sizeof(Quad);
    for (GLuint i = 0; i < vectors; ++i) {
        gl.EnableVertexAttribArray(i);
        gl.VertexAttribPointer(i, 4, GL_FLOAT, GL_FALSE, sizeof(Quad),
                               reinterpret_cast<void const*>(start + i * sizeof(float[4])));
        gl.VertexAttribDivisor(i, 1);
    }
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
