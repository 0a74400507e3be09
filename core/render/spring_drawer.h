#pragma once

#include "core/render/line_drawer.h"

#include <memory>
#include <vector>

namespace esm {

/// Draws a network's springs as lines, painted as the scene says, and its nodes as dots;
/// and over them what is marked and which nodes are fixed.
class SpringDrawer {
public:
    explicit SpringDrawer(const GlFunctions& gl);

    void draw(const RenderScene& scene, const std::vector<Eigen::Vector3d>& nodes, const LineDrawer& lines,
              const Frame& frame);

private:
    /// How springs and nodes are drawn in the picture at hand.
    struct Manner {
        bool bare;        ///< without a surface
        bool overSurface; ///< over one, else in place of it
        bool inside;      ///< seen through it
        float lift;       ///< m, out of it
    };

    /// What the marked dots, or the fixed ones, were uploaded for.
    template<typename Choice> struct Dots {
        Choice choice;
        int pose = 0;
    };

    using SpringPaint = std::shared_ptr<const std::vector<Paint>>;

    SpringPaint paintOf(const RenderScene& scene) const;
    Manner mannerOf(const RenderScene& scene, const Frame& frame) const;
    void takeNetwork(const RenderScene& scene);
    void takeSprings(const RenderScene& scene, bool overSurface);
    void drawSprings(const RenderScene& scene, const Manner& manner, const LineDrawer& lines,
                     const Frame& frame);
    void takeMarked(const RenderScene& scene);
    void takeMarkedDots(const std::shared_ptr<const std::vector<double>>& weights, const Frame& frame);
    void drawMarked(const RenderScene& scene, const Manner& manner, const LineDrawer& lines,
                    const Frame& frame);
    void drawNodes(const RenderScene& scene, const Manner& manner, const LineDrawer& lines,
                   const Frame& frame) const;
    void drawFixed(const std::vector<std::uint32_t>& fixed, const Manner& manner, const LineDrawer& lines,
                   const Frame& frame);

    const GlFunctions& m_gl;
    PointSet m_points, m_fixedPoints, m_markedPoints;
    SegmentSet m_quiet, m_coloured, m_markedSprings;
    std::shared_ptr<const SpringNetwork> m_network;
    std::shared_ptr<const SpringNetwork> m_springsNetwork, m_markedNetwork; ///< of the segments as uploaded
    std::shared_ptr<const std::vector<double>> m_weights; ///< of the marked springs as uploaded
    SpringPaint m_paint, m_markedPaint;                   ///< as uploaded
    std::optional<Colour> m_markedColour;
    bool m_overSurface = false;
    float m_cover = 0;                    ///< m, between the springs and the surface over them
    std::vector<Eigen::Vector3d> m_nodes; ///< as last uploaded
    int m_pose = 0;                       ///< counts what was uploaded of them
    Dots<std::shared_ptr<const std::vector<double>>> m_markedDots;
    Dots<std::vector<std::uint32_t>> m_fixedDots;
};

} // namespace esm
