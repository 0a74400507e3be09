#pragma once

#include "core/texture/atlas/charts/chart_mesh.h"

#include <optional>

namespace esm {

using PlanePoints = std::vector<Eigen::Vector2d>;

/// A disc laid into the plane with its border free, so that its triangles keep their shapes and sizes as well
/// as they can together: of each vertex its place, m, counter-clockwise where the surface is seen from
/// outside. Nothing keeps triangles from folding over or the border from crossing itself, which is for
/// `isSoundlyFlat()` to say. Nothing where the equations have no solution in these numbers.
std::optional<PlanePoints> flattened(const ChartMesh& disc);

} // namespace esm
