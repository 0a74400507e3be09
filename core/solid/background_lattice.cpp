#include "core/solid/background_lattice.h"

#include "core/solid/box_grid.h"
#include "core/solid/lattice_elasticity.h"
#include "core/solid/lattice_sites.h"
#include "core/solid/parallel_nodes.h"
#include "core/solid/unit_cell.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

/// Unit cells over a box, with one more all around, and the numbers of their sites.
struct CellGrid {
    const UnitCell& cell;
    double spacing; ///< m
    Vector3d origin;
    BoxGrid cells{};

    CellGrid(const UnitCell& unitCell, double nodeSpacing, const Eigen::AlignedBox3d& box)
        : cell(unitCell), spacing(nodeSpacing) {
        const double edge = spacing * cell.edge;
        // From a corner of the box, so that a block of whole cells is filled as it is.
        origin = box.min() - Vector3d::Constant(edge);
        const Eigen::Array3d counts = (box.sizes() / edge).array().ceil() + 3;
        checkSiteCount(counts.prod() * static_cast<double>(cell.sites.size()), spacing);
        cells = {counts.cast<int>().matrix()};
    }

    /// noIndex beyond the cells there are.
    std::uint32_t numberOf(const Vector3i& base, const CellSite& site) const {
        const Vector3i place = base + site.cell;
        if (!cells.holds(place)) return noIndex;
        return static_cast<std::uint32_t>(cells.numberOf(place) * cell.sites.size() + site.site);
    }
    Vector3d placeOf(std::size_t number) const {
        const CellSite site{static_cast<std::uint32_t>(number % cell.sites.size()),
                            cells.placeAt(number / cell.sites.size())};
        return origin + spacing * cell.placeOf(site);
    }
};

std::vector<char> sitesWithin(const CellGrid& grid, const SitesOfBody& sites, const Progress& progress) {
    std::vector<char> isInside(grid.cells.size() * grid.cell.sites.size(), 0);
    forEachNode(isInside.size(), progress,
                [&](std::size_t i) { isInside[i] = sites.holds(grid.placeOf(i)) ? 1 : 0; });
    return isInside;
}

/// Leaves out what reaches beyond the cells around the body. Ends of springs are sites until all are taken.
void take(const CellGrid& grid, const Vector3i& base, const CellTetrahedron& tetrahedron, SiteTaker& taker,
          BackgroundLattice& lattice) {
    Tetrahedron sites;
    std::transform(tetrahedron.corners.begin(), tetrahedron.corners.end(), sites.begin(),
                   [&](const CellSite& corner) { return grid.numberOf(base, corner); });
    if (std::find(sites.begin(), sites.end(), noIndex) != sites.end()) return;
    if (!taker.take(sites, std::pow(grid.spacing, 3) * tetrahedron.volume)) return;
    for (const SpringShare& share : tetrahedron.shares)
        lattice.shares.push_back({grid.numberOf(base, share.first), grid.numberOf(base, share.second),
                                  share.constant, grid.spacing * share.length});
    lattice.shareStarts.push_back(static_cast<std::uint32_t>(lattice.shares.size()));
}

/// A spring's end that is no corner of any tetrahedron stays without a number.
void numberShares(const SiteTaker& taker, BackgroundLattice& lattice) {
    for (LatticeShare& share : lattice.shares)
        for (std::uint32_t* end : {&share.first, &share.second})
            *end = *end == noIndex ? noIndex : taker.numberOf(*end);
}

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
    const std::vector<char> isInside = sitesWithin(grid, SitesOfBody(body, query), parts.next(0.8));
    BackgroundLattice lattice;
    lattice.cutStiffness = cutStiffnessOf(kind, spacing);
    lattice.hasSkin = kind == LatticeKind::BareDiamond;
    SiteTaker taker([&](std::size_t site) { return grid.placeOf(site); }, isInside, lattice);
    const Progress takes = parts.rest();
    for (std::size_t cell = 0; cell < grid.cells.size(); ++cell) {
        reportStep(takes, cell, grid.cells.size());
        for (const CellTetrahedron& tetrahedron : grid.cell.tetrahedra)
            take(grid, grid.cells.placeAt(cell), tetrahedron, taker, lattice);
    }
    numberShares(taker, lattice);
    return lattice;
}

} // namespace esm
