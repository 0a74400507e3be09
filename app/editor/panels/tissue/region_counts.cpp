#include "app/editor/panels/tissue/region_counts.h"

#include "app/editor/document/change.h"

#include <algorithm>

namespace esm {

const RegionCount& RegionCounts::of(const Project& project, const Region& region) {
    std::erase_if(m_known, [&](const Known& known) { return !findPart(project.regions, known.region.id); });
    auto known = std::find_if(m_known.begin(), m_known.end(),
                              [&](const Known& other) { return other.region.id == region.id; });
    if (known == m_known.end()) known = m_known.insert(known, Known{});
    if (known->network != project.network || !sameReach(known->region, region))
        *known = {project.network, region, countOf(*project.network, region)};
    return known->count;
}

} // namespace esm
