#pragma once

#include "core/model/project.h"

#include <cstddef>
#include <vector>

namespace esm {

/// How many nodes and springs lie inside each region. Looks at them again only where the network or the
/// region's ellipsoid is another: panels ask on every tick of a slider.
class RegionCounts {
public:
    struct Count {
        std::size_t nodes = 0, springs = 0; ///< a spring is inside when both its ends are
    };

    /// @param region index into the project's regions
    const Count& of(const Project& project, std::size_t region);

private:
    struct Known {
        std::shared_ptr<const SpringNetwork> network;
        std::optional<Ellipsoid> ellipsoid;
        Count count;
    };
    std::vector<Known> m_known; ///< by the region's index
};

} // namespace esm
