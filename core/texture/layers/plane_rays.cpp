#include "core/texture/layers/plane_rays.h"

#include "core/texture/layers/photo_ray.h"

namespace esm {

/// Which side takes colour is asked as in `TriangleProjection`.
std::optional<RayHit> PlaneRays::hit(int column, int row) const {
    const double perColumn = static_cast<double>(m_plane.photo.width) / m_plane.picture.width;
    const double perRow = static_cast<double>(m_plane.photo.height) / m_plane.picture.height;
    const Ray ray =
        rayThrough(m_plane.projector, m_plane.photo, {(column + 0.5) * perColumn, (row + 0.5) * perRow});
    std::optional<RayHit> hit = m_query.firstHit(ray);
    if (!hit) return std::nullopt;
    const Eigen::Vector3d outward = areaNormal(m_mesh.vertices, m_mesh.triangles[hit->triangle]);
    if (!(cosineSeen(m_sides[hit->triangle], -outward.dot(ray.direction)) > 0)) return std::nullopt;
    return hit;
}

} // namespace esm
