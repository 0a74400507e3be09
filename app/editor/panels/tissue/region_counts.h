#pragma once

#include "core/project/project.h"

#include <vector>

namespace esm {

/// How many nodes and springs each region holds. Looks at them again only where the network or the region's
/// ellipsoid or rim is another: panels ask on every tick of a slider.
class RegionCounts {
public:
    /// Of one of the project's regions. What it gives is there until it is asked again.
    const RegionCount& of(const Project& project, const Region& region);

private:
    struct Known {
        std::shared_ptr<const SpringNetwork> network;
        Region region;
        RegionCount count;
    };
    std::vector<Known> m_known; ///< one per region at most
};

} // namespace esm
