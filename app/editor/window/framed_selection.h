#pragma once

#include "core/project/project.h"

#include <optional>

namespace esm {

/// The box around a region's ellipsoid with its rim; none for the whole organ.
std::optional<Eigen::AlignedBox3d> boxOf(const Region& region);

/// The box around what a photo's projector shows of the organ at rest, on the side that faces it; around the
/// photo before the projector where it shows nothing. None for what is painted.
std::optional<Eigen::AlignedBox3d> boxOf(const TextureLayer& layer, const TriangleMesh& mesh);

} // namespace esm
