#include "core/probing/strip_frame.h"

#include "core/geometry/principal_axes.h"
#include "core/support/errors.h"

#include <Eigen/Geometry>

namespace esm {

namespace {

using Eigen::Vector3d;

constexpr double leastSlant = 0.2; ///< of a direction that lies along a surface, as a sine

/// What of a direction lies along a surface; none where it points through it.
std::optional<Vector3d> alongSurface(const Vector3d& direction, const Vector3d& outward) {
    const Vector3d unit = direction.stableNormalized();
    const Vector3d flat = unit - unit.dot(outward) * outward;
    if (!(flat.norm() > leastSlant)) return {};
    return flat.normalized();
}

// Where nobody says it, a strip lies as it is cut out of organs: along a bowel, a vessel, a lobe.
Vector3d directionOf(const std::vector<Vector3d>& places, const StripSettings& settings,
                     const Vector3d& outward) {
    if (settings.along) {
        const auto along =
            settings.along->allFinite() ? alongSurface(*settings.along, outward) : std::nullopt;
        if (!along)
            throw InvalidModel("the strip's direction must be three finite numbers that point along the "
                               "organ's surface at the place, not through it");
        return *along;
    }
    const Eigen::Matrix3d axes = principalAxes(places);
    for (const Eigen::Index longest : {2, 1, 0})
        if (const auto along = alongSurface(axes.col(longest), outward)) return *along;
    return outward.unitOrthogonal();
}

} // namespace

StripFrame stripFrame(const TriangleMesh& surface, const SurfaceSpot& spot, const StripSettings& settings) {
    const Vector3d outward = outwardAround(surface, spot, settings.width / 2);
    const Eigen::AngleAxisd turn(settings.turn, outward);
    const Vector3d along = turn * directionOf(surface.vertices, settings, outward);
    return {spot.point, along, outward.cross(along), outward};
}

} // namespace esm
