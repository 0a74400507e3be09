#include "core/solid/lattice_estimate.h"

#include "core/solid/graded_lattice.h"
#include "core/solid/unit_cell.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

/// Nodes that cuts add per spacing² of surface, beyond those that the volume has: measured on eight organs.
double surfaceNodesPerArea(LatticeKind kind) {
    switch (kind) {
    case LatticeKind::Cubic:
        return 0.6;
    case LatticeKind::BodyCentred:
    case LatticeKind::Graded:
        return 0.88;
    default:
        return 0.5;
    }
}

} // namespace

LatticeEstimator::LatticeEstimator(const std::vector<ClosedBody>& bodies, LatticeKind kind)
    : m_bodies(bodies), m_kind(kind) {
    if (kind != LatticeKind::Graded) return;
    constexpr double mostPlaces = 4096, fewestPlaces = 64; // crumbs hardly count
    for (const ClosedBody& body : bodies) {
        const double places = mostPlaces * body.volume / largestOf(bodies).volume;
        m_depths.push_back(depthsWithin(body, static_cast<std::size_t>(std::max(places, fewestPlaces))));
    }
}

// Nodes within go with the volume, those at cuts with the surface; each kind's lattice has so many springs
// and tetrahedra for a node within. A graded lattice has fewer within, by how deep the body is.
LatticeEstimate LatticeEstimator::estimateIn(std::size_t body, double spacing) const {
    const UnitCell& cell = unitCellOf(m_kind);
    const double own = spacingWithin(m_bodies[body], spacing);
    const double graded = m_depths.empty() ? 1 : gradedShare(m_depths[body], own);
    const double within = graded * cell.density() * m_bodies[body].volume / std::pow(own, 3),
                 cuts = surfaceNodesPerArea(m_kind) * m_bodies[body].area / (own * own);
    const auto sites = static_cast<double>(cell.sites.size());
    constexpr double springsPerCut = 3, moreTetrahedra = 1.04, bytesPerNode = 4000; // measured as well
    return {within + cuts, within * static_cast<double>(cell.springs.size()) / sites + springsPerCut * cuts,
            moreTetrahedra * within * static_cast<double>(cell.tetrahedra.size()) / sites,
            bytesPerNode * (within + cuts), own};
}

LatticeEstimate LatticeEstimator::estimate(double spacing) const {
    LatticeEstimate whole{0, 0, 0, 0, spacingWithin(largestOf(m_bodies), spacing)};
    for (std::size_t i = 0; i < m_bodies.size(); ++i) {
        const LatticeEstimate part = estimateIn(i, spacing);
        whole.nodes += part.nodes;
        whole.springs += part.springs;
        whole.tetrahedra += part.tetrahedra;
        whole.bytes += part.bytes;
    }
    return whole;
}

} // namespace esm
