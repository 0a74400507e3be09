#include "core/render/wireframe_drawer.h"

namespace esm {
namespace {

constexpr float edgeLift = 0.001F; // of the organ's size
constexpr float edgeWidth = 1;     // pixels
constexpr Paint edgeOverSurface{24, 21, 26, 150}, edgeAlone{152, 161, 171, 190};

} // namespace

WireframeDrawer::WireframeDrawer(const GlFunctions& gl) : m_gl(gl), m_points(gl), m_edges(gl) {}

/// Over the surface the edges of its far side are hidden by it; alone all are seen, near ones before far
/// ones.
void WireframeDrawer::draw(const RenderScene& scene, const std::vector<Eigen::Vector3d>& vertices,
                           const LineDrawer& lines, const Frame& frame) {
    if (!scene.showWireframe || !scene.mesh || scene.mesh->triangles.empty()) return;
    if (scene.mesh != m_mesh || scene.showSurface != m_overSurface) takeEdges(scene);
    if (vertices != m_vertices) {
        m_points.upload(vertices, frame);
        m_vertices = vertices;
    }
    m_gl.DepthMask(m_overSurface ? GL_FALSE : GL_TRUE);
    lines.draw(m_points, m_edges, {1, m_overSurface ? edgeLift * frame.size : 0, true}, frame);
    m_gl.DepthMask(GL_TRUE);
}

void WireframeDrawer::takeEdges(const RenderScene& scene) {
    if (scene.mesh != m_mesh) m_vertices.clear(); // relative to another organ's middle
    m_mesh = scene.mesh;
    m_overSurface = scene.showSurface;
    const std::vector<Edge> edges = uniqueEdges(m_mesh->triangles);
    std::vector<Segment> segments;
    segments.reserve(edges.size());
    for (const auto& [first, second] : edges)
        segments.push_back({first, second, m_overSurface ? edgeOverSurface : edgeAlone, edgeWidth});
    m_edges.upload(segments);
}

} // namespace esm
