#include "core/probing/strip_gauge.h"

#include <Eigen/Dense>

#include <cmath>

namespace esm {

namespace {

using Eigen::Vector3d;

constexpr double seenPart = 1.0 / 3; ///< of the length, on either side of the middle

/// From the cell's first corner to each other one; 0 for those it has not.
Eigen::Matrix3d edgesOf(const TissueCell& cell, const std::vector<Vector3d>& places) {
    Eigen::Matrix3d edges = Eigen::Matrix3d::Zero();
    for (std::size_t i = 1; i < cell.cornerCount; ++i)
        edges.col(static_cast<Eigen::Index>(i - 1)) = places[cell.corners[i]] - places[cell.corners[0]];
    return edges;
}

/// 1 in the middle, falling smoothly to 0 where no more is seen.
double seen(double fromMiddle, double reach) {
    if (std::abs(fromMiddle) >= reach) return 0;
    return (1 + std::cos(M_PI * fromMiddle / reach)) / 2;
}

} // namespace

// A triangle that lies aslant is stretched along its own plane. The area over which the strip's force is
// spread is that of its slice between two planes across the strip: it is smaller by the cosine of the slant.
StripGauge::StripGauge(const CutStrip& strip, double length)
    : m_along(strip.frame.along), m_window(seenPart * length) {
    const std::vector<Vector3d>& rest = strip.tissue.network->restPositions;
    for (const TissueCell& cell : strip.cells) {
        const double part = seen(strip.frame.coordinatesOf(middleOf(cell, rest)).x(), m_window);
        if (part <= 0) continue;
        const Eigen::Matrix3d edges = edgesOf(cell, rest);
        const Vector3d mix = edges.completeOrthogonalDecomposition().solve(m_along);
        const double cosine = (edges * mix).norm();
        if (!(cosine > 0)) continue;
        m_watched.push_back({cell, mix / cosine, part * cosine * sizeOf(cell, rest)});
        m_whole += m_watched.back().weight;
    }
}

// The force of a cell counts by what of it goes along the strip, which is not all until a bent strip is
// straight. Divided by the cross-section of rest, as laboratories do, it is an engineering stress.
double StripGauge::strain(const std::vector<Vector3d>& positions) const {
    double sum = 0;
    for (const auto& [cell, mix, weight] : m_watched) {
        const Vector3d way = edgesOf(cell, positions) * mix;
        const double length = way.norm();
        if (length > 0) sum += weight * (length - 1) * way.dot(m_along) / length;
    }
    return m_whole > 0 ? sum / m_whole : 0;
}

} // namespace esm
