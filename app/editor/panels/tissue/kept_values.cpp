#include "app/editor/panels/tissue/kept_values.h"

namespace esm {

QString KeptValues::text(const Project& project, const Region& region, Parameter parameter) {
    const auto place = placeOf(project.regions, region.id);
    const auto end = project.regions.begin() + static_cast<std::ptrdiff_t>(place.value_or(0));
    Place now{project.network, project.base, {project.regions.begin(), end}, region.ellipsoid, region.rim};
    if (!(now == m_place)) {
        m_beneath = tissueBeneath(project, region);
        m_place = std::move(now);
    }
    return m_beneath ? QString::fromStdString(inWords(*m_beneath, parameter)) : QString();
}

} // namespace esm
