#include "app/editor/panels/region_counts.h"

namespace esm {

namespace {

bool sameShape(const std::optional<Ellipsoid>& a, const std::optional<Ellipsoid>& b) {
    if (!a || !b) return !a && !b;
    return a->centre == b->centre && a->radii == b->radii &&
           a->orientation.coeffs() == b->orientation.coeffs();
}

} // namespace

const RegionCounts::Count& RegionCounts::of(const Project& project, std::size_t region) {
    m_known.resize(project.regions.size());
    Known& known = m_known[region];
    const Region& asked = project.regions[region];
    if (known.network == project.network && sameShape(known.ellipsoid, asked.ellipsoid)) return known.count;
    const RegionResult result = evaluateRegion(project, asked);
    known = {project.network, asked.ellipsoid, {result.nodes, result.springs}};
    return known.count;
}

} // namespace esm
