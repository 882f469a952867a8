// Owners of GL's textures, framebuffers and programs in one context.
#pragma once

#include <string>
#include <vector>

#include "screen/gl_table.h"

namespace screen {

// How a texture is read between its texels and beyond its edges.
enum class Sampling { exact, tiled };

class Texture {
public:
    Texture(GladGLContext const& gl, GLint format, int width, int height, Sampling sampling);
    ~Texture();
    Texture(Texture const&) = delete;
    Texture& operator=(Texture const&) = delete;

    GLuint name() const { return name_; }
    int width() const { return width_; }
    int height() const { return height_; }
    void bind(int unit) const;
    // One byte a texel into a box of the texture.
    void upload(int left, int top, int width, int height, std::uint8_t const* bytes) const;
    // A copy at half the size of the level before; all down to one texel are needed.
    void add_level(int level, int width, int height, std::uint8_t const* bytes) const;
    // What lies between texels: a blend, or the nearest one, which costs less.
    void blend_texels() const;
    void take_nearest_texels() const;

private:
    void filter(GLint smaller, GLint larger) const;

    GladGLContext const& gl_;
    GLuint name_ = 0;
    int width_, height_;
};

// A picture that can be painted on: a texture, four bytes a pixel.
class Canvas {
public:
    Canvas(GladGLContext const& gl, int width, int height);
    ~Canvas();
    Canvas(Canvas const&) = delete;
    Canvas& operator=(Canvas const&) = delete;

    int width() const { return colours_.width(); }
    int height() const { return colours_.height(); }
    void paint_here() const;
    void read_from_here() const;
    void copy_from(Canvas const& other) const;  // of the same size

private:
    GladGLContext const& gl_;
    Texture colours_;
    GLuint name_ = 0;
};

class GlProgram {
public:
    // Throws std::runtime_error with GL's words when a shader does not compile.
    GlProgram(GladGLContext const& gl, std::string const& vertex, std::string const& fragment);
    ~GlProgram();
    GlProgram(GlProgram const&) = delete;
    GlProgram& operator=(GlProgram const&) = delete;

    void use() const;
    void set(char const* uniform, float x, float y) const;
    void set_unit(char const* sampler, int unit) const;

private:
    GladGLContext const& gl_;
    GLuint name_ = 0;
};

}  // namespace screen
