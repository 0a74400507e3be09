#pragma once

#include "core/geometry/surface_spot.h"
#include "core/probing/probe.h"
#include "core/surface/surface_query.h"

namespace esm {

/// Where an organ's simulated surface at rest is nearest to a place, m.
/// @throws InvalidModel where the place is further off than a coarser surface than the drawn one may be
RayHit probedHit(const ProbedOrgan& organ, const Eigen::Vector3d& place);
/// The same as a spot of that surface, whose nodes are at these places, m.
SurfaceSpot spotAt(const RayHit& hit, const std::vector<Triangle>& surface,
                   const std::vector<Eigen::Vector3d>& positions);

} // namespace esm
