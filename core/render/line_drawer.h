#pragma once

#include "core/render/frame.h"
#include "core/render/gl_objects.h"

#include <vector>

namespace esm {

/// A straight line between two points of a list.
struct Segment {
    std::uint32_t first, second;
    Paint paint;
    float width; ///< pixels of the design
};

struct LineStyle {
    float opacity = 1;
    float lift = 0;             ///< m towards the eye, so that lines on a surface lie over it
    bool thinWhenShort = false; ///< lines of a few pixels fade, so that a dense net stays a veil
};

struct DotStyle {
    Eigen::Vector4f paint; ///< red, green, blue, alpha
    float radius;          ///< pixels of the design
    float edge = 0;        ///< pixels of the design, of the radius, that are dark
    float lift = 0;        ///< m towards the eye, besides the little that every dot is lifted
};

/// Points in space on the graphics card, and lines and dots drawn at them.
class PointSet {
public:
    explicit PointSet(const GlFunctions& gl);
    /// @param strengths of the points' dots, 0 to 1; all in full without
    void upload(const std::vector<Eigen::Vector3d>& points, const Frame& frame,
                const std::vector<float>& strengths = {});
    void bind(int unit) const { m_texture.bind(GL_TEXTURE_BUFFER, unit); }
    GLsizei size() const { return m_size; }

private:
    GlBuffer m_buffer;
    GlTexture m_texture;
    GLsizei m_size = 0;
};

class SegmentSet {
public:
    explicit SegmentSet(const GlFunctions& gl);
    void upload(const std::vector<Segment>& segments);
    void bind() const { m_array.bind(); }
    GLsizei size() const { return m_size; }

private:
    GlBuffer m_buffer;
    GlVertexArray m_array;
    GLsizei m_size = 0;
};

/// Draws lines of any width with smooth edges, and round dots.
class LineDrawer {
public:
    explicit LineDrawer(const GlFunctions& gl);
    void draw(const PointSet& points, const SegmentSet& segments, const LineStyle& style,
              const Frame& frame) const;
    /// A dot at every point.
    void drawDots(const PointSet& points, const DotStyle& style, const Frame& frame) const;

private:
    const GlFunctions& m_gl;
    GlProgram m_lines, m_dots;
    GlVertexArray m_emptyArray;
};

} // namespace esm
