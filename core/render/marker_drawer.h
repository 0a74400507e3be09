#pragma once

#include "core/render/line_drawer.h"

#include <map>
#include <memory>
#include <vector>

namespace esm {

/// Those of the scene and the one that is held.
std::vector<PlacedCollider> instrumentsOf(const RenderScene& scene);

/// Draws what stands around the organ: region ellipsoids, projector boxes and instruments.
class MarkerDrawer {
public:
    explicit MarkerDrawer(const GlFunctions& gl);

    void drawInstrument(const PlacedCollider& instrument, const Frame& frame) const;
    /// Half-transparent parts and their lines, over everything drawn before.
    /// @param shown box of the organ, through which the projectors' boxes reach
    void drawTransparent(const RenderScene& scene, const Eigen::AlignedBox3d& shown, const LineDrawer& lines,
                         const Frame& frame);

private:
    struct Curves;

    void drawHiddenInstrument(const PlacedCollider& instrument, const Frame& frame) const;
    void drawShell(const DrawnEllipsoid& ellipsoid, const Frame& frame) const;
    void drawBoxFaces(const DrawnProjector& projector, const Eigen::AlignedBox3d& shown, const Frame& frame);
    void drawQuad(const std::array<Eigen::Vector3d, 4>& corners, const Eigen::Vector4f& paint,
                  const GlTexture* photo, const Frame& frame) const;
    void drawCurves(const Curves& curves, const LineStyle& style, const LineDrawer& lines,
                    const Frame& frame);
    struct Ball;

    void drawBall(const GlProgram& program, const Ball& ball, const Frame& frame) const;
    const GlTexture* photoTexture(const std::shared_ptr<const Image>& photo);

    const GlFunctions& m_gl;
    GlProgram m_steel, m_shell, m_quad;
    GlBuffer m_ballVertices, m_ballIndices;
    GlVertexArray m_ball, m_emptyArray;
    GLsizei m_ballIndexCount = 0;
    PointSet m_curvePoints;
    SegmentSet m_curveSegments;
    std::map<std::shared_ptr<const Image>, std::unique_ptr<GlTexture>> m_photos;
};

} // namespace esm
