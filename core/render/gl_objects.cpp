#include "core/render/gl_objects.h"

#include "core/texture/photo/photo_sampler.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace esm {
namespace {

/// The driver's own words go into the message: what a driver refuses, only its log tells.
GLuint compiled(const GlFunctions& gl, GLenum kind, const std::string& source) {
    const GLuint shader = gl.CreateShader(kind);
    const char* text = source.c_str();
    gl.ShaderSource(shader, 1, &text, nullptr);
    gl.CompileShader(shader);
    GLint succeeded = 0;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &succeeded);
    if (succeeded) return shader;
    std::vector<char> log(4096, '\0');
    gl.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()) - 1, nullptr, log.data());
    gl.DeleteShader(shader);
    throw std::runtime_error(std::string("the graphics driver refuses a shader: ") + log.data());
}

GLint limitOf(const GlFunctions& gl, GLenum what) {
    GLint limit = 0;
    gl.GetIntegerv(what, &limit);
    return limit;
}

} // namespace

GlProgram::GlProgram(const GlFunctions& gl, const std::string& vertexShader,
                     const std::string& fragmentShader)
    : m_gl(gl), m_id(gl.CreateProgram()) {
    for (const auto& [kind, source] :
         {std::pair<GLenum, const std::string&>(GL_VERTEX_SHADER, vertexShader),
          std::pair<GLenum, const std::string&>(GL_FRAGMENT_SHADER, fragmentShader)}) {
        const GLuint shader = compiled(gl, kind, source);
        gl.AttachShader(m_id, shader);
        gl.DeleteShader(shader);
    }
    gl.LinkProgram(m_id);
    GLint succeeded = 0;
    gl.GetProgramiv(m_id, GL_LINK_STATUS, &succeeded);
    if (succeeded) return;
    std::vector<char> log(4096, '\0');
    gl.GetProgramInfoLog(m_id, static_cast<GLsizei>(log.size()) - 1, nullptr, log.data());
    throw std::runtime_error(std::string("the graphics driver cannot link a shader: ") + log.data());
}

GlProgram::~GlProgram() {
    m_gl.DeleteProgram(m_id);
}

void GlProgram::use() const {
    m_gl.UseProgram(m_id);
}

GLint GlProgram::location(const char* uniform) const {
    return m_gl.GetUniformLocation(m_id, uniform);
}

void GlProgram::set(const char* uniform, int value) const {
    m_gl.Uniform1i(location(uniform), value);
}

void GlProgram::set(const char* uniform, float value) const {
    m_gl.Uniform1f(location(uniform), value);
}

void GlProgram::set(const char* uniform, const Eigen::Vector2f& value) const {
    m_gl.Uniform2f(location(uniform), value.x(), value.y());
}

void GlProgram::set(const char* uniform, const Eigen::Vector3f& value) const {
    m_gl.Uniform3f(location(uniform), value.x(), value.y(), value.z());
}

void GlProgram::set(const char* uniform, const Eigen::Vector4f& value) const {
    m_gl.Uniform4f(location(uniform), value.x(), value.y(), value.z(), value.w());
}

void GlProgram::set(const char* uniform, const Eigen::Matrix4f& value) const {
    m_gl.UniformMatrix4fv(location(uniform), 1, GL_FALSE, value.data());
}

GlBuffer::GlBuffer(const GlFunctions& gl) : m_gl(gl) {
    m_gl.GenBuffers(1, &m_id);
}

GlBuffer::~GlBuffer() {
    m_gl.DeleteBuffers(1, &m_id);
}

void GlBuffer::upload(GLenum target, const void* data, std::size_t bytes, GLenum usage) {
    m_bytes = bytes;
    bind(target);
    m_gl.BufferData(target, static_cast<GLsizeiptr>(bytes), data, usage);
}

void GlBuffer::bind(GLenum target) const {
    m_gl.BindBuffer(target, m_id);
}

GlVertexArray::GlVertexArray(const GlFunctions& gl) : m_gl(gl) {
    m_gl.GenVertexArrays(1, &m_id);
}

GlVertexArray::~GlVertexArray() {
    m_gl.DeleteVertexArrays(1, &m_id);
}

void GlVertexArray::bind() const {
    m_gl.BindVertexArray(m_id);
}

void GlVertexArray::addFloats(GLuint index, GLint components, GLsizei stride, std::size_t offset) const {
    m_gl.EnableVertexAttribArray(index);
    m_gl.VertexAttribPointer(index, components, GL_FLOAT, GL_FALSE, stride,
                             reinterpret_cast<const void*>(offset));
}

GlTexture::GlTexture(const GlFunctions& gl) : m_gl(gl) {
    m_gl.GenTextures(1, &m_id);
}

GlTexture::~GlTexture() {
    m_gl.DeleteTextures(1, &m_id);
}

void GlTexture::upload(const Image& image, int levels) {
    if (!fits(image.width, image.height)) return upload(halved(image), std::max(levels - 1, 0));
    m_tiled.clear();
    filter(levels);
    put(image, 0);
    if (levels > 0) m_gl.GenerateMipmap(GL_TEXTURE_2D);
}

void GlTexture::upload(const TiledImage& image, const std::vector<TiledImage>& smaller) {
    if (!fits(image.width(), image.height())) {
        if (smaller.empty()) return upload(image.image(), 0);
        return upload(smaller.front(), {smaller.begin() + 1, smaller.end()});
    }
    std::vector<TiledImage> levels{image};
    levels.insert(levels.end(), smaller.begin(), smaller.end());
    const bool goesOn = std::equal(levels.begin(), levels.end(), m_tiled.begin(), m_tiled.end(),
                                   [](const auto& now, const auto& before) { return now.isLike(before); });
    filter(static_cast<int>(smaller.size()));
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const int level = static_cast<int>(i);
        if (!goesOn) allocate(levels[i], level);
        put(levels[i], goesOn ? &m_tiled[i] : nullptr, level);
    }
    m_tiled = std::move(levels);
}

bool GlTexture::fits(int width, int height) const {
    return std::max(width, height) <= limitOf(m_gl, GL_MAX_TEXTURE_SIZE);
}

void GlTexture::filter(int levels) {
    bind(GL_TEXTURE_2D, 0);
    m_gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    m_gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    m_gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    m_gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    m_gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                       levels > 0 ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
    m_gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, levels);
}

void GlTexture::put(const Image& image, int level) {
    m_gl.TexImage2D(GL_TEXTURE_2D, level, GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                    image.pixels.data());
}

void GlTexture::allocate(const TiledImage& image, int level) {
    m_gl.TexImage2D(GL_TEXTURE_2D, level, GL_RGBA8, image.width(), image.height(), 0, GL_RGBA,
                    GL_UNSIGNED_BYTE, nullptr);
}

void GlTexture::put(const TiledImage& image, const TiledImage* before, int level) {
    const TileSize tile = image.tileSize();
    m_gl.PixelStorei(GL_UNPACK_ROW_LENGTH, tile.width);
    for (int row = 0; row < image.rows(); ++row)
        for (int column = 0; column < image.columns(); ++column) {
            if (before && image.sharesTile(*before, column, row)) continue;
            const int left = column * tile.width, top = row * tile.height;
            m_gl.TexSubImage2D(GL_TEXTURE_2D, level, left, top, std::min(tile.width, image.width() - left),
                               std::min(tile.height, image.height() - top), GL_RGBA, GL_UNSIGNED_BYTE,
                               image.tile(column, row).data());
        }
    m_gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

void GlTexture::attach(const GlBuffer& buffer) {
    const std::size_t texels = buffer.bytes() / sizeof(Eigen::Vector4f);
    const auto limit = static_cast<std::size_t>(limitOf(m_gl, GL_MAX_TEXTURE_BUFFER_SIZE));
    if (texels > limit)
        throw std::runtime_error("the model is too large for the graphics driver, " + std::to_string(texels) +
                                 " points and normals where " + std::to_string(limit) +
                                 " fit; a coarser mesh or a newer driver may help");
    bind(GL_TEXTURE_BUFFER, 0);
    m_gl.TexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, buffer.id());
}

void GlTexture::bind(GLenum target, int unit) const {
    m_gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    m_gl.BindTexture(target, m_id);
}

} // namespace esm
