#pragma once

#include "core/geometry/surface_spot.h"
#include "core/probing/probe.h"
#include "core/surface/surface_query.h"

namespace esm {

/// The spot of an organ's simulated surface that is nearest to a place, m.
/// @throws InvalidModel where the place is further off than a coarser surface than the drawn one may be
SurfaceSpot probedSpot(const ProbedOrgan& organ, const SurfaceQuery& query, const Eigen::Vector3d& place);

/// "12.3 mm"
std::string lengthText(double metres);

} // namespace esm
