#pragma once

#include "core/project/project.h"

#include <cstddef>
#include <vector>

namespace esm {

/// How many nodes and springs each region holds. Looks at them again only where the network or the region's
/// ellipsoid or rim is another: panels ask on every tick of a slider.
class RegionCounts {
public:
    /// @param region index into the project's regions
    const RegionCount& of(const Project& project, std::size_t region);

private:
    struct Known {
        std::shared_ptr<const SpringNetwork> network;
        Region region;
        RegionCount count;
    };
    std::vector<Known> m_known; ///< by the region's index
};

} // namespace esm
