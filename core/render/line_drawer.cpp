#include "core/render/line_drawer.h"

#include "core/render/shaders.h"

#include <algorithm>
#include <cstddef>

namespace esm {
namespace {

constexpr float dotLiftShare = 0.004F; // of the organ's size

void setView(const GlProgram& program, const Frame& frame) {
    program.set("view", frame.view);
    program.set("projection", frame.projection);
    program.set("cut", frame.cut);
    program.set("pixels", frame.pixels);
    program.set("points", 0);
}

} // namespace

PointSet::PointSet(const GlFunctions& gl) : m_buffer(gl), m_texture(gl) {}

/// Places are handed over relative to the frame's origin in the organ's middle: floats have 24 bits, and of a
/// file that lies metres from 0 these would be spent on the way there.
void PointSet::upload(const std::vector<Eigen::Vector3d>& points, const Frame& frame,
                      const std::vector<float>& strengths) {
    std::vector<Eigen::Vector4f> texels(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Eigen::Vector3f place = frame.local(points[i]);
        texels[i] = {place.x(), place.y(), place.z(), strengths.empty() ? 1.0F : strengths[i]};
    }
    m_size = static_cast<GLsizei>(points.size());
    m_buffer.upload(GL_TEXTURE_BUFFER, texels.data(), texels.size() * sizeof(Eigen::Vector4f),
                    GL_STREAM_DRAW);
    m_texture.attach(m_buffer);
}

SegmentSet::SegmentSet(const GlFunctions& gl) : m_buffer(gl), m_array(gl) {
    m_array.bind();
    m_buffer.bind(GL_ARRAY_BUFFER);
    gl.EnableVertexAttribArray(0);
    gl.VertexAttribIPointer(0, 2, GL_UNSIGNED_INT, sizeof(Segment), nullptr);
    gl.EnableVertexAttribArray(1);
    gl.VertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(Segment),
                           reinterpret_cast<const void*>(offsetof(Segment, paint)));
    m_array.addFloats(2, 1, sizeof(Segment), offsetof(Segment, width));
    for (const GLuint index : {0U, 1U, 2U})
        gl.VertexAttribDivisor(index, 1);
}

void SegmentSet::upload(const std::vector<Segment>& segments) {
    m_size = static_cast<GLsizei>(segments.size());
    m_buffer.upload(GL_ARRAY_BUFFER, segments.data(), segments.size() * sizeof(Segment), GL_STATIC_DRAW);
}

LineDrawer::LineDrawer(const GlFunctions& gl)
    : m_gl(gl), m_lines(gl, shaders::lineVertex(), shaders::lineFragment()),
      m_dots(gl, shaders::pointVertex(), shaders::pointFragment()), m_emptyArray(gl) {}

/// A segment is an instance of four corners that the shader spreads to the width in pixels: GL's own lines
/// are one pixel wide in core profiles. Both ends are looked up by number in the texture of points, so that
/// springs that move upload points alone.
void LineDrawer::draw(const PointSet& points, const SegmentSet& segments, const LineStyle& style,
                      const Frame& frame) const {
    if (segments.size() == 0) return;
    m_lines.use();
    setView(m_lines, frame);
    m_lines.set("pixelRatio", frame.pixelRatio);
    m_lines.set("opacity", style.opacity);
    m_lines.set("lift", style.lift);
    m_lines.set("thinWhenShort", style.thinWhenShort);
    points.bind(0);
    segments.bind();
    m_gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, segments.size());
}

void LineDrawer::drawDots(const PointSet& points, const DotStyle& style, const Frame& frame) const {
    if (points.size() == 0) return;
    m_dots.use();
    setView(m_dots, frame);
    m_dots.set("tint", style.paint);
    m_dots.set("radius", style.radius * frame.pixelRatio);
    m_dots.set("edge", style.edge * frame.pixelRatio);
    m_dots.set("lift", dotLiftShare * frame.size + style.lift);
    points.bind(0);
    m_emptyArray.bind();
    m_gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, points.size());
}

} // namespace esm
