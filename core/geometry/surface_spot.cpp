#include "core/geometry/surface_spot.h"

#include "core/geometry/shortest_turn.h"

namespace esm {

using Eigen::Vector3d;

// The mean over a patch, since the normal of the one triangle that was pointed at says more of the mesh than
// of the organ.
Vector3d outwardAround(const TriangleMesh& mesh, const SurfaceSpot& spot, double radius) {
    Vector3d sum = Vector3d::Zero();
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vector3d &first = mesh.vertices[a], &second = mesh.vertices[b], &third = mesh.vertices[c];
        if (((first + second + third) / 3 - spot.point).norm() > radius) continue;
        const Vector3d area = (second - first).cross(third - first);
        if (area.dot(spot.outward) > 0) sum += area;
    }
    return sum.norm() > 0 ? Vector3d(sum.stableNormalized()) : spot.outward;
}

// The patch is as large as the ellipsoid's own footprint: what it lies on decides how it lies. Of all turns
// that take z outwards the shortest is taken, so that x and y stay as near as can be to where they were.
Ellipsoid laidOn(const TriangleMesh& mesh, const SurfaceSpot& spot, const Vector3d& radii) {
    const Vector3d outward = outwardAround(mesh, spot, std::max(radii.x(), radii.y()));
    return {spot.point, radii, Eigen::Quaterniond(shortestTurn(Vector3d::UnitZ(), outward))};
}

} // namespace esm
