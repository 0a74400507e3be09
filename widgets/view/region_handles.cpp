#include "widgets/view/region_handles.h"

#include "core/render/drawn_shape.h"

#include <algorithm>
#include <cmath>

namespace esm {
namespace {

using Eigen::Vector3d;

constexpr double shortAxis =
    0.35; // sine of an axis' angle to the line of sight below which it has no handles

bool pointsAtViewer(const Vector3d& end, const Vector3d& centre, const Camera& camera) {
    const Vector3d axis = (end - centre).normalized(), sight = towardsViewer(camera, centre);
    return axis.cross(sight).norm() < shortAxis;
}

double distanceToNearest(const std::vector<RegionHandle>& handles, const Vector3d& point) {
    double nearest = HUGE_VAL;
    for (const RegionHandle& handle : handles)
        nearest = std::min(nearest, (handle.place - point).norm());
    return nearest;
}

/// On the outline, upper right, and of those places the one that is farthest from all other handles: none is
/// hidden under another.
std::optional<Vector3d> rimPlace(const DrawnEllipsoid& region, const Camera& camera,
                                 const std::vector<RegionHandle>& others) {
    const Eigen::Matrix3d axes = cameraAxes(camera);
    const Vector3d eye = viewpoint(camera, region.shape.radii.maxCoeff());
    std::optional<Vector3d> best;
    for (const Vector3d& point : rimSilhouette(region.shape, region.rim, eye)) {
        const Vector3d offset = point - region.shape.centre;
        if (offset.dot(axes.col(0)) < 0 || offset.dot(axes.col(1)) < 0) continue;
        if (!best || distanceToNearest(others, point) > distanceToNearest(others, *best)) best = point;
    }
    return best;
}

} // namespace

/// An axis that points at the viewer has its end right over the middle: a drag across the picture could not
/// tell longer from shorter, so it has no handles until the view is turned.
std::vector<RegionHandle> regionHandles(const DrawnEllipsoid& region, const Camera& camera,
                                        double turnReach) {
    using Kind = RegionHandle::Kind;
    std::vector<RegionHandle> found;
    const Vector3d& centre = region.shape.centre;
    const auto ends = handles(region.shape);
    for (std::size_t end = 0; end < ends.size(); ++end) {
        if (pointsAtViewer(ends[end], centre, camera)) continue;
        found.push_back({Kind::Size, end, ends[end], ends[end]});
        const Vector3d beyond = ends[end] + turnReach * (ends[end] - centre).normalized();
        if (end % 2 == 0) found.push_back({Kind::Turn, end, beyond, ends[end]});
    }
    if (const auto rim = rimPlace(region, camera, found)) found.push_back({Kind::Rim, 0, *rim, *rim});
    return found;
}

Ellipsoid turned(const Ellipsoid& ellipsoid, const Grip& grip, const Ray& ray) {
    Ellipsoid result = ellipsoid;
    result.orientation = (ballTurn(ellipsoid.centre, grip, ray) * ellipsoid.orientation).normalized();
    return result;
}

} // namespace esm
