#include "core/solid/graded_lattice.h"

#include "core/solid/graded_cells.h"
#include "core/solid/lattice_sites.h"
#include "core/solid/parallel_nodes.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

/// Numbers of the places where cubes may have corners and middles: first all even ones, then all odd ones.
class GradedSites {
public:
    explicit GradedSites(const GradedCells& cells)
        : m_cells(cells), m_grid{cells.grid.counts + Vector3i::Ones()} {}

    std::size_t count() const { return 2 * m_grid.size(); }
    std::uint32_t numberOf(const Vector3i& place) const {
        const bool isOdd = place.x() % 2 != 0;
        return static_cast<std::uint32_t>(m_grid.numberOf(place / 2) + (isOdd ? m_grid.size() : 0));
    }
    Vector3i at(std::size_t number) const {
        const bool isOdd = number >= m_grid.size();
        return 2 * m_grid.placeAt(number % m_grid.size()) + Vector3i::Constant(isOdd ? 1 : 0);
    }
    Vector3d placeOf(std::size_t number) const { return m_cells.placeOf(at(number)); }

    /// Deep within: in or at a cube that is wider than the finest, so that nobody needs to ask.
    bool isInWideCube(std::size_t number) const {
        const Vector3i cell = at(number) / 2;
        return m_cells.grid.holds(cell) && m_cells.doublingsAt(cell) > 0;
    }

private:
    const GradedCells& m_cells;
    BoxGrid m_grid;
};

std::vector<char> sitesWithin(const GradedSites& sites, const SitesOfBody& body, const Progress& progress) {
    std::vector<char> isInside(sites.count());
    forEachNode(isInside.size(), progress, [&](std::size_t i) {
        isInside[i] = sites.isInWideCube(i) || body.holds(sites.placeOf(i)) ? 1 : 0;
    });
    return isInside;
}

// Of a lattice of equal cubes each tetrahedron gives a sixth of a neighbour's constant to each of its edges:
// six of them lie around a short edge, whose constant is 1, and four around a long one, whose constant is
// 2/3. Twice as wide and of the same modulus, springs are twice as stiff. Between two widths no constants are
// known that make the lattice isotropic to the last digit; those of any tetrahedron stand in.
void addShares(const GradedTetrahedron& tetrahedron, const Tetrahedron& corners, BackgroundLattice& lattice) {
    const double volume = lattice.volumes.back();
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = i + 1; j < 4; ++j) {
            const double length = (lattice.points[corners[i]] - lattice.points[corners[j]]).norm();
            const double constant = tetrahedron.isOfLattice
                                        ? (1 << tetrahedron.doublings) / 6.0
                                        : lattice.cutStiffness * volume / (length * length);
            lattice.shares.push_back({corners[i], corners[j], constant, length});
        }
    lattice.shareStarts.push_back(static_cast<std::uint32_t>(lattice.shares.size()));
}

/// A radical inverse, which spreads numbers evenly between 0 and 1 (van der Corput 1935).
double spread(std::uint32_t number, std::uint32_t base) {
    double result = 0, digit = 1;
    for (; number > 0; number /= base) {
        digit /= base;
        result += digit * (number % base);
    }
    return result;
}

} // namespace

// Labelle and Shewchuk (2007) grade a body-centred lattice by cubes that double in width. A cube's middle is
// joined with that of each neighbour of its size around the face between them, and with each face of a
// smaller one. At the surface cubes are all of the finest width, so that it is cut as an even lattice is.
BackgroundLattice gradedLattice(double spacing, const ClosedBody& body, const BodyQuery& query,
                                const Progress& progress) {
    ProgressParts parts(progress);
    const double edge = 2 / std::sqrt(3.0) * spacing;
    const GradedCells cells = gradedCells(edge, body, query, parts.next(0.2));
    const GradedSites sites(cells);
    const std::vector<char> isInside = sitesWithin(sites, SitesOfBody(body, query), parts.next(0.6));
    BackgroundLattice lattice;
    lattice.cutStiffness = cutStiffnessOf(LatticeKind::Graded, spacing);
    SiteTaker taker([&](std::size_t site) { return sites.placeOf(site); }, isInside, lattice);
    const Progress takes = parts.rest();
    for (std::size_t cell = 0; cell < cells.grid.size(); ++cell) {
        reportStep(takes, cell, cells.grid.size());
        for (const GradedTetrahedron& tetrahedron : tetrahedraAt(cells, cells.grid.placeAt(cell))) {
            Tetrahedron corners;
            std::transform(tetrahedron.corners.begin(), tetrahedron.corners.end(), corners.begin(),
                           [&](const Vector3i& place) { return sites.numberOf(place); });
            const double volume = tetrahedron.volume() * std::pow(edge / 2, 3);
            if (taker.take(corners, volume)) addShares(tetrahedron, lattice.tetrahedra.back(), lattice);
        }
    }
    return lattice;
}

std::vector<double> depthsWithin(const ClosedBody& body, std::size_t places) {
    const BodyQuery query(body);
    const Eigen::AlignedBox3d box = boundingBox(body.surface.vertices);
    std::vector<double> depths(places, -1);
    forEachNode(places, {}, [&](std::size_t i) {
        const auto number = static_cast<std::uint32_t>(i + 1);
        const Vector3d part(spread(number, 2), spread(number, 3), spread(number, 5));
        const Vector3d place = box.min() + part.cwiseProduct(box.sizes());
        if (query.contains(place)) depths[i] = query.nearest(place).distance;
    });
    depths.erase(std::remove(depths.begin(), depths.end(), -1), depths.end());
    std::sort(depths.begin(), depths.end());
    return depths;
}

// A cube is doubled where all of it lies `leastDepth` of its width deep. Its middle then lies half a width
// deeper, or 0.87 where the wall stands across its diagonal. With one and a half widths for all, nodes of
// seven organs were told within 4 %.
double gradedShare(const std::vector<double>& depths, double spacing) {
    double share = 1;
    const double edge = 2 / std::sqrt(3.0) * spacing;
    for (int doublings = 1; doublings <= mostDoublings && !depths.empty(); ++doublings) {
        const double deep = 1.5 * (1 << doublings) * edge;
        const auto deeper = depths.end() - std::lower_bound(depths.begin(), depths.end(), deep);
        const double replaced = std::pow(1 / 8.0, doublings - 1) - std::pow(1 / 8.0, doublings);
        share -= replaced * static_cast<double>(deeper) / static_cast<double>(depths.size());
    }
    return share;
}

} // namespace esm
