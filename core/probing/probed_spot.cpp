#include "core/probing/probed_spot.h"

#include "core/support/errors.h"
#include "core/support/numbers.h"

namespace esm {

namespace {

using Eigen::Vector3d;

/// Of the organ's size: so far may a place be off the surface, which a coarser one than the drawn is too.
constexpr double nearEnough = 0.02;

std::string spotText(const Vector3d& place) {
    return roundedText(place.x(), 4) + " " + roundedText(place.y(), 4) + " " + roundedText(place.z(), 4);
}

} // namespace

RayHit probedHit(const ProbedOrgan& organ, const Vector3d& place) {
    const std::vector<Vector3d>& nodes = organ.model.network->restPositions;
    const std::optional<RayHit> hit = SurfaceQuery(nodes, organ.surface.triangles).nearest(place);
    if (!hit) throw InvalidModel("the place must be three finite numbers");
    if (hit->distance > nearEnough * boundingBox(nodes).diagonal().norm())
        throw InvalidModel("the place is " + millimetresText(hit->distance, 3) +
                           " off the organ's surface; its nearest point is " +
                           spotText(spotAt(*hit, organ.surface.triangles, nodes).point) + " m");
    return *hit;
}

SurfaceSpot spotAt(const RayHit& hit, const std::vector<Triangle>& surface,
                   const std::vector<Vector3d>& positions) {
    const Triangle& triangle = surface[hit.triangle];
    SurfaceSpot spot{Vector3d::Zero(), areaNormal(positions, triangle).normalized()};
    for (int i = 0; i < 3; ++i)
        spot.point += hit.barycentric[i] * positions[triangle[static_cast<std::size_t>(i)]];
    return spot;
}

} // namespace esm
