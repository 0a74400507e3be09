#include "core/solid/background_lattice.h"

#include "core/solid/lattice_elasticity.h"
#include "core/solid/parallel_nodes.h"
#include "core/solid/unit_cell.h"
#include "core/support/errors.h"
#include "core/support/numbers.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

/// Of a box, which take a GB or so; those of a million nodes within the box of an organ are far fewer.
constexpr double mostSites = 1e8;

/// Unit cells over a box, with one more all around, and the numbers of their sites.
struct CellGrid {
    const UnitCell& cell;
    double spacing; ///< m
    Vector3d origin;
    Vector3i counts;

    CellGrid(const UnitCell& unitCell, double nodeSpacing, const Eigen::AlignedBox3d& box)
        : cell(unitCell), spacing(nodeSpacing) {
        const double edge = spacing * cell.edge;
        // From a corner of the box, so that a block of whole cells is filled as it is.
        origin = box.min() - Vector3d::Constant(edge);
        const Eigen::Array3d cells = (box.sizes() / edge).array().ceil() + 3;
        if (cells.prod() * static_cast<double>(cell.sites.size()) > mostSites)
            throw InvalidModel(
                "a part of the surface is too long for how thin it is: around it a spacing of " +
                roundedText(1000 * spacing, 2) + " mm makes too many nodes; leave it out at import");
        counts = cells.cast<int>();
    }

    std::size_t cellCount() const {
        return static_cast<std::size_t>(counts.x()) * static_cast<std::size_t>(counts.y()) *
               static_cast<std::size_t>(counts.z());
    }
    Vector3i cellAt(std::size_t number) const {
        const auto x = static_cast<std::size_t>(counts.x()), y = static_cast<std::size_t>(counts.y());
        return {static_cast<int>(number % x), static_cast<int>(number / x % y),
                static_cast<int>(number / x / y)};
    }
    /// noIndex beyond the cells there are.
    std::uint32_t numberOf(const Vector3i& base, const CellSite& site) const {
        const Vector3i place = base + site.cell;
        if ((place.array() < 0).any() || (place.array() >= counts.array()).any()) return noIndex;
        const auto cellNumber = (static_cast<std::size_t>(place.z()) * static_cast<std::size_t>(counts.y()) +
                                 static_cast<std::size_t>(place.y())) *
                                    static_cast<std::size_t>(counts.x()) +
                                static_cast<std::size_t>(place.x());
        return static_cast<std::uint32_t>(cellNumber * cell.sites.size() + site.site);
    }
    Vector3d placeOf(std::size_t number) const {
        const CellSite site{static_cast<std::uint32_t>(number % cell.sites.size()),
                            cellAt(number / cell.sites.size())};
        return origin + spacing * cell.placeOf(site);
    }
};

/// Whether each site of the grid lies within the body. Sites on a side of its box are looked at closely: a
/// block is bounded by such sites, and would lose its corners were they taken for outside.
std::vector<char> sitesWithin(const CellGrid& grid, const ClosedBody& body, const BodyQuery& query,
                              const Progress& progress) {
    const Eigen::AlignedBox3d box = boundingBox(body.surface.vertices);
    const double slack = 1e-9 * box.sizes().maxCoeff();
    const Eigen::AlignedBox3d outer(box.min().array() - slack, box.max().array() + slack),
        inner(box.min().array() + slack, box.max().array() - slack);
    std::vector<char> isInside(grid.cellCount() * grid.cell.sites.size(), 0);
    forEachNode(isInside.size(), progress, [&](std::size_t i) {
        const Vector3d place = grid.placeOf(i);
        if (!outer.contains(place)) return;
        isInside[i] = query.contains(place) || (!inner.contains(place) && query.isOn(place)) ? 1 : 0;
    });
    return isInside;
}

/// Of a whole grid two thirds lie outside an organ. Only what has a corner inside is kept, and its points are
/// numbered anew, in the order of the cells: neighbours in space lie near each other in memory.
///
/// Takes tetrahedra over into a lattice whose points are numbered in the order of their first use.
class PointTaker {
public:
    PointTaker(const CellGrid& grid, const std::vector<char>& isInside, BackgroundLattice& lattice)
        : m_grid(grid), m_isInside(isInside), m_lattice(lattice), m_numbers(isInside.size(), noIndex) {}

    std::uint32_t taken(std::uint32_t site) {
        std::uint32_t& number = m_numbers[site];
        if (number == noIndex) {
            number = static_cast<std::uint32_t>(m_lattice.points.size());
            m_lattice.points.push_back(m_grid.placeOf(site));
            m_lattice.isInside.push_back(m_isInside[site]);
        }
        return number;
    }

    void take(const Vector3i& base, const CellTetrahedron& tetrahedron) {
        std::array<std::uint32_t, 4> sites;
        bool isWanted = false;
        for (std::size_t i = 0; i < 4; ++i) {
            sites[i] = m_grid.numberOf(base, tetrahedron.corners[i]);
            if (sites[i] == noIndex) return; // beyond the cells around the body
            isWanted = isWanted || m_isInside[sites[i]];
        }
        if (!isWanted) return;
        Tetrahedron corners;
        std::transform(sites.begin(), sites.end(), corners.begin(), [&](auto site) { return taken(site); });
        m_lattice.tetrahedra.push_back(corners);
        m_lattice.volumes.push_back(std::pow(m_grid.spacing, 3) * tetrahedron.volume);
        for (const SpringShare& share : tetrahedron.shares)
            m_lattice.shares.push_back({m_grid.numberOf(base, share.first),
                                        m_grid.numberOf(base, share.second), share.constant,
                                        m_grid.spacing * share.length});
        m_lattice.shareStarts.push_back(static_cast<std::uint32_t>(m_lattice.shares.size()));
    }

    /// A spring's end that is no corner of any tetrahedron stays without a number.
    void numberShares() {
        for (LatticeShare& share : m_lattice.shares)
            for (std::uint32_t* end : {&share.first, &share.second})
                *end = *end == noIndex ? noIndex : m_numbers[*end];
    }

private:
    const CellGrid& m_grid;
    const std::vector<char>& m_isInside;
    BackgroundLattice& m_lattice;
    std::vector<std::uint32_t> m_numbers;
};

} // namespace

// A tetrahedral solid of modulus E and ν = 1/4 has springs E·V/L² along the edges of a tetrahedron of volume
// V (Van Gelder 1998): its mean over all directions is exact whatever the tetrahedron's shape, and it is what
// the lattices' own constants come to in their own.
double cutStiffnessOf(LatticeKind kind, double spacing) {
    return relativeModulus(kind) / spacing;
}

BackgroundLattice uniformLattice(LatticeKind kind, double spacing, const ClosedBody& body,
                                 const BodyQuery& query, const Progress& progress) {
    ProgressParts parts(progress);
    const CellGrid grid(unitCellOf(kind), spacing, boundingBox(body.surface.vertices));
    const std::vector<char> isInside = sitesWithin(grid, body, query, parts.next(0.8));
    BackgroundLattice lattice;
    lattice.cutStiffness = cutStiffnessOf(kind, spacing);
    lattice.hasSkin = kind == LatticeKind::BareDiamond;
    PointTaker taker(grid, isInside, lattice);
    const Progress takes = parts.rest();
    for (std::size_t cell = 0; cell < grid.cellCount(); ++cell) {
        reportStep(takes, cell, grid.cellCount());
        for (const CellTetrahedron& tetrahedron : grid.cell.tetrahedra)
            taker.take(grid.cellAt(cell), tetrahedron);
    }
    taker.numberShares();
    return lattice;
}

} // namespace esm
