#pragma once

#include "core/render/line_drawer.h"

#include <memory>
#include <vector>

namespace esm {

/// Draws the edges of an organ's triangles, thin over its surface or alone.
class WireframeDrawer {
public:
    explicit WireframeDrawer(const GlFunctions& gl);

    void draw(const RenderScene& scene, const std::vector<Eigen::Vector3d>& vertices, const LineDrawer& lines,
              const Frame& frame);

private:
    void takeEdges(const RenderScene& scene);

    const GlFunctions& m_gl;
    PointSet m_points;
    SegmentSet m_edges;
    std::shared_ptr<const TriangleMesh> m_mesh; ///< of the edges as uploaded
    bool m_overSurface = false;
    std::vector<Eigen::Vector3d> m_vertices; ///< as last uploaded
};

} // namespace esm
