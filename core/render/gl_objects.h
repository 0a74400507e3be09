#pragma once

#include "core/render/gl_functions.h"
#include "core/texture/image.h"
#include "core/texture/tiled_image.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace esm {

/// A linked shader program. Uniforms are set on the program in use.
class GlProgram {
public:
    /// @throws std::runtime_error with the driver's message
    GlProgram(const GlFunctions& gl, const std::string& vertexShader, const std::string& fragmentShader);
    GlProgram(const GlProgram&) = delete;
    GlProgram& operator=(const GlProgram&) = delete;
    ~GlProgram();

    void use() const;
    void set(const char* uniform, int value) const;
    void set(const char* uniform, float value) const;
    void set(const char* uniform, const Eigen::Vector2f& value) const;
    void set(const char* uniform, const Eigen::Vector3f& value) const;
    void set(const char* uniform, const Eigen::Vector4f& value) const;
    void set(const char* uniform, const Eigen::Matrix4f& value) const;

private:
    GLint location(const char* uniform) const;

    const GlFunctions& m_gl;
    GLuint m_id;
};

class GlBuffer {
public:
    explicit GlBuffer(const GlFunctions& gl);
    GlBuffer(const GlBuffer&) = delete;
    GlBuffer& operator=(const GlBuffer&) = delete;
    ~GlBuffer();

    /// Replaces the content; the driver may still be reading the last one.
    void upload(GLenum target, const void* data, std::size_t bytes, GLenum usage);
    void bind(GLenum target) const;
    GLuint id() const { return m_id; }
    std::size_t bytes() const { return m_bytes; }

private:
    const GlFunctions& m_gl;
    GLuint m_id = 0;
    std::size_t m_bytes = 0;
};

class GlVertexArray {
public:
    explicit GlVertexArray(const GlFunctions& gl);
    GlVertexArray(const GlVertexArray&) = delete;
    GlVertexArray& operator=(const GlVertexArray&) = delete;
    ~GlVertexArray();

    void bind() const;
    /// Takes `components` floats from the buffer bound to GL_ARRAY_BUFFER; this array must be bound.
    void addFloats(GLuint index, GLint components, GLsizei stride, std::size_t offset) const;

private:
    const GlFunctions& m_gl;
    GLuint m_id = 0;
};

/// Pixels of the longer side that are uploaded of a photo, so that a large one does not take its size several
/// times over. No picture of the window shows more of it.
constexpr int largestDrawnPhoto = 4096;

/// A picture for shaders, rows from the top: (0, 0) is its top left corner.
class GlTexture {
public:
    explicit GlTexture(const GlFunctions& gl);
    GlTexture(const GlTexture&) = delete;
    GlTexture& operator=(const GlTexture&) = delete;
    ~GlTexture();

    /// Bilinear, with smaller copies down to `levels` halvings. A picture larger than the driver takes is
    /// halved until it fits.
    void upload(const Image& image, int levels);
    /// The same of a picture in tiles, with smaller copies that are given, each half the size of the one
    /// before. Where pictures of the same sizes lie there already, only tiles that are others are uploaded.
    void upload(const TiledImage& image, const std::vector<TiledImage>& smaller);
    /// Shaders read the buffer as `vec4` texels. @throws std::runtime_error for more than the driver takes
    void attach(const GlBuffer& buffer);
    void bind(GLenum target, int unit) const;

private:
    bool fits(int width, int height) const;
    void filter(int levels);
    void put(const Image& image, int level);
    void allocate(const TiledImage& image, int level);
    /// @param before what lies there; null for nothing
    void put(const TiledImage& image, const TiledImage* before, int level);

    const GlFunctions& m_gl;
    GLuint m_id = 0;
    std::vector<TiledImage> m_tiled; ///< as uploaded last, the largest first; empty for another kind
};

} // namespace esm
