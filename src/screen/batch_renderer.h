// Draws batches: owns the programs, the buffer and the textures of one context.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "screen/edge_atlas.h"
#include "screen/gl_objects.h"
#include "screen/glyphs.h"
#include "screen/shape_batch.h"

namespace screen {

// All calls need the context to be current. `gl` must outlive the renderer.
class BatchRenderer {
public:
    explicit BatchRenderer(GladGLContext const& gl);
    ~BatchRenderer();
    BatchRenderer(BatchRenderer const&) = delete;
    BatchRenderer& operator=(BatchRenderer const&) = delete;

    // Of what is drawn on, pixels.
    void fit(int width, int height);

    // How grain is read is one for a whole batch: where another scale asks for another way, the batch must be drawn
    // before.
    bool has_grain_for(double pixels_per_metre) const;
    void choose_grain(double pixels_per_metre);

    // `glyphs` may be null where the batch has none.
    void draw(Batch const& batch, EdgeAtlas const& edges, Glyphs* glyphs);

private:
    GlProgram const& program(Program which);
    void point_at(int first_quad);
    void upload(EdgeAtlas const& edges, Glyphs* glyphs);

    GladGLContext const& gl_;
    GLuint records_ = 0, layout_ = 0;  // a buffer and how the shaders read it
    std::array<std::unique_ptr<GlProgram>, program_count> programs_;
    // In turn: one that a draw still waits for is not written to, which would have to wait for that.
    std::array<std::unique_ptr<Texture>, 2> coverages_;
    std::size_t coverage_ = 0;
    std::unique_ptr<Texture> grain_, atlas_;
    std::optional<bool> grain_blended_;
    int width_ = 0, height_ = 0;
};

}  // namespace screen
