#pragma once

#include "core/render/line_drawer.h"

#include <memory>
#include <vector>

namespace esm {

/// Draws a network's springs as lines, coloured by value where the scene gives values, and its nodes as dots.
class SpringDrawer {
public:
    explicit SpringDrawer(const GlFunctions& gl);

    void draw(const RenderScene& scene, const std::vector<Eigen::Vector3d>& nodes, const LineDrawer& lines,
              const Frame& frame);

private:
    void takeSprings(const RenderScene& scene, bool overSurface);
    void drawMarks(const std::vector<std::uint32_t>& marked, float radius, const LineDrawer& lines,
                   const Frame& frame);

    const GlFunctions& m_gl;
    PointSet m_points, m_marks;
    SegmentSet m_quiet, m_coloured;
    std::shared_ptr<const SpringNetwork> m_network;
    std::shared_ptr<const std::vector<double>> m_values;
    double m_minimum = 0, m_maximum = 0;
    bool m_overSurface = false;
    float m_cover = 0;                    ///< m, between the springs and the surface over them
    std::vector<Eigen::Vector3d> m_nodes; ///< as last uploaded
};

} // namespace esm
