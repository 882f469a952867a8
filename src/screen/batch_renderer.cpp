#include "screen/batch_renderer.h"

#include <cmath>
#include <cstdint>
#include <string>

#include "screen/grain.h"
#include "screen/shaders.h"

namespace screen {
namespace {

constexpr int coverage_unit = 0, grain_unit = 1, atlas_unit = 2;

std::string fragment_source(Program program) {
    std::string const head = shaders::fragment_head, area = head + shaders::area;
    switch (program) {
        case Program::disc:
            return head + shaders::disc;
        case Program::box:
            return head + shaders::box;
        case Program::arc:
            return head + shaders::arc;
        case Program::plain_area:
            return head + shaders::plain_area;
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

// Magnified texels are blended, for else they would be seen as squares.
bool is_magnified(double pixels_per_metre) {
    constexpr double slightly = 1.1;
    return pixels_per_metre > slightly * grain_side / grain_metres;
}

}  // namespace

BatchRenderer::BatchRenderer(GladGLContext const& gl) : gl_(gl) {
    gl_.GenBuffers(1, &records_);
    gl_.GenVertexArrays(1, &layout_);
}

BatchRenderer::~BatchRenderer() {
    gl_.DeleteBuffers(1, &records_);
    gl_.DeleteVertexArrays(1, &layout_);
}

void BatchRenderer::fit(int width, int height) {
    width_ = width;
    height_ = height;
    for (auto& made : programs_) made.reset();
}

bool BatchRenderer::has_grain_for(double pixels_per_metre) const {
    return grain_blended_ == is_magnified(pixels_per_metre);
}

void BatchRenderer::choose_grain(double pixels_per_metre) {
    if (!grain_) grain_ = grain_texture(gl_);
    bool const blended = is_magnified(pixels_per_metre);
    blended ? grain_->blend_texels() : grain_->take_nearest_texels();
    grain_blended_ = blended;
}

GlProgram const& BatchRenderer::program(Program which) {
    auto& made = programs_[static_cast<std::size_t>(which)];
    if (made) {
        made->use();
        return *made;
    }
    made = std::make_unique<GlProgram>(gl_, shaders::vertex, fragment_source(which));
    made->use();
    made->set("frame_size", static_cast<float>(width_), static_cast<float>(height_));
    made->set_unit("coverage", coverage_unit);
    made->set_unit("grain", grain_unit);
    made->set_unit("atlas", atlas_unit);
    return *made;
}

void BatchRenderer::upload(EdgeAtlas const& edges, Glyphs* glyphs) {
    if (glyphs && glyphs->changed_top() < glyphs->changed_bottom()) {
        if (!atlas_) atlas_ = std::make_unique<Texture>(gl_, GL_R8, atlas_side, atlas_side, Sampling::exact);
        int const top = glyphs->changed_top();
        std::uint8_t const* const first = glyphs->atlas().data() + static_cast<std::size_t>(top) * atlas_side;
        atlas_->upload(0, top, atlas_side, glyphs->changed_bottom() - top, first);
        glyphs->mark_seen();
    }
    if (coverages_[coverage_] && edges.is_empty()) return;
    coverage_ = 1 - coverage_;
    auto& coverage = coverages_[coverage_];
    if (!coverage) coverage = std::make_unique<Texture>(gl_, GL_R8, edge_atlas_side, edge_atlas_side, Sampling::exact);
    coverage->upload(0, 0, edge_atlas_side, edges.rows(), edges.texels());
}

void BatchRenderer::draw(Batch const& batch, EdgeAtlas const& edges, Glyphs* glyphs) {
    upload(edges, glyphs);
    coverages_[coverage_]->bind(coverage_unit);
    if (grain_) grain_->bind(grain_unit);
    if (atlas_) atlas_->bind(atlas_unit);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl_.BindVertexArray(layout_);
    gl_.BindBuffer(GL_ARRAY_BUFFER, records_);
    auto const size = static_cast<GLsizeiptr>(batch.quads.size() * sizeof(Quad));
    gl_.BufferData(GL_ARRAY_BUFFER, size, batch.quads.data(), GL_STREAM_DRAW);
    for (Run const& run : batch.runs) {
        program(run.program).use();
        if (run.blending == Blending::over)
            gl_.Enable(GL_BLEND);
        else
            gl_.Disable(GL_BLEND);
        point_at(run.first);
        gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, run.count);
    }
}

void BatchRenderer::point_at(int first_quad) {
    constexpr GLuint vectors = sizeof(Quad) / sizeof(float[4]);
    auto const start = static_cast<std::uintptr_t>(first_quad) * sizeof(Quad);
    for (GLuint i = 0; i < vectors; ++i) {
        gl_.EnableVertexAttribArray(i);
        gl_.VertexAttribPointer(i, 4, GL_FLOAT, GL_FALSE, sizeof(Quad),
                                reinterpret_cast<void const*>(start + i * sizeof(float[4])));
        gl_.VertexAttribDivisor(i, 1);
    }
}

}  // namespace screen
