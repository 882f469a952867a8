#include "screen/gl_objects.h"

#include <stdexcept>

namespace screen {
namespace {

GLuint compiled(GladGLContext const& gl, GLenum kind, std::string const& source) {
    GLuint const shader = gl.CreateShader(kind);
    char const* const text = source.c_str();
    gl.ShaderSource(shader, 1, &text, nullptr);
    gl.CompileShader(shader);
    GLint done = GL_FALSE;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &done);
    if (done == GL_TRUE) return shader;
    std::string words(1000, '\0');
    GLsizei length = 0;
    gl.GetShaderInfoLog(shader, static_cast<GLsizei>(words.size()), &length, words.data());
    gl.DeleteShader(shader);
    words.resize(static_cast<std::size_t>(length));
    throw std::runtime_error("OpenGL does not take a shader: " + words.substr(0, words.find('\n')));
}

}  // namespace

Texture::Texture(GladGLContext const& gl, GLint format, int width, int height, Sampling sampling)
    : gl_(gl), width_(width), height_(height) {
    gl_.GenTextures(1, &name_);
    gl_.BindTexture(GL_TEXTURE_2D, name_);
    GLenum const channels = format == GL_R8 ? GL_RED : GL_RGBA;
    gl_.TexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, channels, GL_UNSIGNED_BYTE, nullptr);
    bool const tiled = sampling == Sampling::tiled;
    filter(GL_NEAREST, GL_NEAREST);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, tiled ? GL_REPEAT : GL_CLAMP_TO_EDGE);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, tiled ? GL_REPEAT : GL_CLAMP_TO_EDGE);
}

Texture::~Texture() { gl_.DeleteTextures(1, &name_); }

void Texture::bind(int unit) const {
    gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    gl_.BindTexture(GL_TEXTURE_2D, name_);
}

void Texture::upload(int left, int top, int width, int height, std::uint8_t const* bytes) const {
    gl_.BindTexture(GL_TEXTURE_2D, name_);
    gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl_.TexSubImage2D(GL_TEXTURE_2D, 0, left, top, width, height, GL_RED, GL_UNSIGNED_BYTE, bytes);
}

void Texture::add_level(int level, int width, int height, std::uint8_t const* bytes) const {
    gl_.BindTexture(GL_TEXTURE_2D, name_);
    gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl_.TexImage2D(GL_TEXTURE_2D, level, GL_R8, width, height, 0, GL_RED, GL_UNSIGNED_BYTE, bytes);
}

void Texture::filter(GLint smaller, GLint larger) const {
    gl_.BindTexture(GL_TEXTURE_2D, name_);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, smaller);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, larger);
}

void Texture::blend_texels() const { filter(GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR); }
void Texture::take_nearest_texels() const { filter(GL_NEAREST_MIPMAP_NEAREST, GL_NEAREST); }

Canvas::Canvas(GladGLContext const& gl, int width, int height)
    : gl_(gl), colours_(gl, GL_RGBA8, width, height, Sampling::exact) {
    gl_.GenFramebuffers(1, &name_);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, name_);
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colours_.name(), 0);
    if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return;
    gl_.DeleteFramebuffers(1, &name_);
    throw std::runtime_error("OpenGL cannot paint a picture of " + std::to_string(width) + "x" +
                             std::to_string(height));
}

Canvas::~Canvas() { gl_.DeleteFramebuffers(1, &name_); }

void Canvas::paint_here() const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, name_);
    gl_.Viewport(0, 0, width(), height());
}

void Canvas::read_from_here() const { gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, name_); }

void Canvas::copy_from(Canvas const& other) const {
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, other.name_);
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, name_);
    gl_.BlitFramebuffer(0, 0, width(), height(), 0, 0, width(), height(), GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

GlProgram::GlProgram(GladGLContext const& gl, std::string const& vertex, std::string const& fragment) : gl_(gl) {
    GLuint const vertex_shader = compiled(gl, GL_VERTEX_SHADER, vertex);
    GLuint const fragment_shader = compiled(gl, GL_FRAGMENT_SHADER, fragment);
    name_ = gl_.CreateProgram();
    gl_.AttachShader(name_, vertex_shader);
    gl_.AttachShader(name_, fragment_shader);
    gl_.LinkProgram(name_);
    gl_.DeleteShader(vertex_shader);
    gl_.DeleteShader(fragment_shader);
    GLint done = GL_FALSE;
    gl_.GetProgramiv(name_, GL_LINK_STATUS, &done);
    if (done == GL_TRUE) return;
    gl_.DeleteProgram(name_);
    throw std::runtime_error("OpenGL does not link a shader");
}

GlProgram::~GlProgram() { gl_.DeleteProgram(name_); }

void GlProgram::use() const { gl_.UseProgram(name_); }

void GlProgram::set(char const* uniform, float x, float y) const {
    gl_.Uniform2f(gl_.GetUniformLocation(name_, uniform), x, y);
}

void GlProgram::set_unit(char const* sampler, int unit) const {
    gl_.Uniform1i(gl_.GetUniformLocation(name_, sampler), unit);
}

}  // namespace screen
