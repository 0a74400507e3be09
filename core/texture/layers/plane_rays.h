#pragma once

#include "core/surface/surface_query.h"
#include "core/texture/layers/seen_sides.h"
#include "core/texture/layers/surface_beneath.h"

#include <optional>

namespace esm {

/// Rays through the pixels of a photo's plane, and what of a surface takes the projector's colour there.
class PlaneRays {
public:
    /// @param sides of the triangles, see `seenSides`; outlive this, as the others do
    PlaneRays(const TriangleMesh& mesh, const SurfaceQuery& query, const PhotoPlane& plane,
              const std::vector<SeenSide>& sides)
        : m_mesh(mesh), m_query(query), m_plane(plane), m_sides(sides) {}

    /// Through the middle of a pixel; nothing where it meets no surface, or one that turns away.
    std::optional<RayHit> hit(int column, int row) const;

private:
    const TriangleMesh& m_mesh;
    const SurfaceQuery& m_query;
    const PhotoPlane& m_plane;
    const std::vector<SeenSide>& m_sides;
};

} // namespace esm
