#include "app/editor/panels/tissue/region_counts.h"

#include "app/editor/document/change.h"

namespace esm {

const RegionCount& RegionCounts::of(const Project& project, std::size_t region) {
    m_known.resize(project.regions.size());
    Known& known = m_known[region];
    const Region& asked = project.regions[region];
    if (known.network != project.network || !sameReach(known.region, asked))
        known = {project.network, asked, countOf(*project.network, asked)};
    return known.count;
}

} // namespace esm
