#pragma once

#include "core/geometry/collider.h"

#include <cstdint>
#include <optional>

namespace esm {

/// A pull in progress: the node that was caught and where the mouse wants it.
struct Pull {
    std::uint32_t node;
    Eigen::Vector3d target; ///< m

    bool operator==(const Pull&) const = default;
};

/// What acts on the preview from outside.
struct PreviewLoads {
    std::optional<Pull> pull;
    std::optional<PlacedCollider> instrument;
    bool gentleMotion = false; ///< the slow pull of a newly opened organ

    bool operator==(const PreviewLoads&) const = default;
};

} // namespace esm
