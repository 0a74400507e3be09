#include "core/probing/indenter_placing.h"

#include "core/probing/probed_spot.h"
#include "core/support/errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {

namespace {

using Eigen::Vector3d;

constexpr int mostSteps = 400, bisections = 40;

// The mean over what the finger will cover, since one triangle says more of the mesh than of the organ. Two
// meshes of an organ are then pressed in nearly the same direction.
Vector3d inwardsAt(const StandingOrgan& standing, const SurfaceSpot& spot, const ProbeSettings& settings) {
    if (!settings.direction)
        return -outwardAround({standing.positions, standing.organ.surface.triangles, {}}, spot,
                              settings.radius);
    if (!settings.direction->allFinite() || settings.direction->norm() == 0)
        throw InvalidModel("the direction to press in must be three finite numbers that are not all 0");
    Vector3d inwards = settings.direction->stableNormalized();
    if (inwards.dot(spot.outward) >= 0)
        throw InvalidModel("the direction to press in points out of the organ there: turn it round");
    return inwards;
}

/// From a place inwards to the next wall. The ray begins a little inside, so that it does not meet the
/// triangle that it starts from; an open sheet has no other side.
double wayToNextWall(const SurfaceQuery& query, const Vector3d& place, const Vector3d& inwards, double size) {
    const double skipped = 1e-6 * size;
    const std::optional<RayHit> hit = query.firstHit({place + skipped * inwards, inwards});
    return hit ? hit->distance + skipped : std::numeric_limits<double>::infinity();
}

/// A wall of prisms can be dented deeper than it is thick: beneath it lies the organ's cavity, until its
/// inner side meets the wall on the other side.
double roomAt(const ProbedOrgan& organ, const SurfaceQuery& query, const Vector3d& place,
              const Vector3d& inwards) {
    const double size = boundingBox(organ.model.network->restPositions).diagonal().norm();
    const double tissue = wayToNextWall(query, place, inwards, size);
    const std::optional<Lattice>& lattice = organ.model.network->lattice;
    if (!lattice || !isWall(lattice->filling) || !std::isfinite(tissue)) return tissue;
    return wayToNextWall(query, place + tissue * inwards, inwards, size);
}

// What stands out beside the place may be touched first. So the sphere is drawn back until it is free, and
// let in again until it just touches: depths count from there, as in Hertz' law, in which a depth that begins
// a tenth too early takes a seventh off the modulus.
Vector3d touchingCentre(const SurfaceQuery& query, const Vector3d& place, const Vector3d& inwards,
                        double radius) {
    const auto centre = [&](double back) -> Vector3d { return place - (radius + back) * inwards; };
    const auto touches = [&](double back) {
        const auto nearest = query.nearest(centre(back));
        return nearest && nearest->distance < radius;
    };
    const double step = radius / 4;
    double touching = -step, free = 0;
    for (int i = 0; i < mostSteps && touches(free); ++i)
        touching = free, free += step;
    // Within a cavity narrower than the finger no step back makes it free.
    if (touches(free))
        throw InvalidModel(
            "the finger has no room before the organ there: choose another place, or a smaller radius");
    for (int i = 0; i < bisections; ++i) {
        const double middle = (touching + free) / 2;
        (touches(middle) ? touching : free) = middle;
    }
    return centre(touching);
}

/// @throws InvalidModel where the tissue that a sphere touches is fixed
void requireGivingWay(const StandingOrgan& standing, const SurfaceQuery& query, const Vector3d& centre) {
    const Triangle& touched = standing.organ.surface.triangles[query.nearest(centre)->triangle];
    if (std::all_of(touched.begin(), touched.end(),
                    [&](std::uint32_t node) { return standing.isImmovable[node]; }))
        throw InvalidModel("the tissue at the place to press is fixed or held by nothing, and cannot be "
                           "pressed in: choose another place");
}

} // namespace

PlacedIndenter placedIndenter(const StandingOrgan& standing, const RayHit& place,
                              const ProbeSettings& settings) {
    const std::vector<Triangle>& triangles = standing.organ.surface.triangles;
    const SurfaceQuery query(standing.positions, triangles);
    const SurfaceSpot spot = spotAt(place, triangles, standing.positions);
    const Vector3d inwards = inwardsAt(standing, spot, settings);
    const double thickness = roomAt(standing.organ, query, spot.point, inwards);
    const Vector3d centre = touchingCentre(query, spot.point, inwards, settings.radius);
    requireGivingWay(standing, query, centre);
    return {{settings.radius, centre, inwards}, thickness};
}

} // namespace esm
