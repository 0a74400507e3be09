#include "core/solid/lattice_sites.h"

#include "core/support/errors.h"
#include "core/support/numbers.h"

#include <algorithm>

namespace esm {

namespace {

/// Of a box, which take a GB or so; those of a million nodes within the box of an organ are far fewer.
constexpr double mostSites = 1e8;

} // namespace

SitesOfBody::SitesOfBody(const ClosedBody& body, const BodyQuery& query) : m_query(query) {
    const Eigen::AlignedBox3d box = boundingBox(body.surface.vertices);
    const double slack = 1e-9 * box.sizes().maxCoeff();
    m_outer = {box.min().array() - slack, box.max().array() + slack};
    m_inner = {box.min().array() + slack, box.max().array() - slack};
}

bool SitesOfBody::holds(const Eigen::Vector3d& place) const {
    if (!m_outer.contains(place)) return false;
    return m_query.contains(place) || (!m_inner.contains(place) && m_query.isOn(place));
}

void checkSiteCount(double sites, double spacing) {
    if (sites > mostSites)
        throw InvalidModel("a part of the surface is too long for how thin it is: around it a spacing of " +
                           millimetresText(spacing, 2) + " makes too many nodes; leave it out at import");
}

bool SiteTaker::take(const Tetrahedron& sites, double volume) {
    if (std::none_of(sites.begin(), sites.end(), [&](auto site) { return m_isInside[site]; })) return false;
    Tetrahedron corners;
    std::transform(sites.begin(), sites.end(), corners.begin(), [&](auto site) { return taken(site); });
    m_lattice.tetrahedra.push_back(corners);
    m_lattice.volumes.push_back(volume);
    return true;
}

std::uint32_t SiteTaker::taken(std::uint32_t site) {
    std::uint32_t& number = m_numbers[site];
    if (number == noIndex) {
        number = static_cast<std::uint32_t>(m_lattice.points.size());
        m_lattice.points.push_back(m_placeOf(site));
        m_lattice.isInside.push_back(m_isInside[site]);
    }
    return number;
}

} // namespace esm
