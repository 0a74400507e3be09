#pragma once

#include "core/probing/strip_frame.h"

#include <array>
#include <cstdint>
#include <span>

namespace esm {

/// What tissue is made of: a triangle of a wall, or a tetrahedron of a solid.
struct TissueCell {
    std::array<std::uint32_t, 4> corners;
    std::size_t cornerCount; ///< 3 or 4

    std::span<const std::uint32_t> nodes() const { return {corners.data(), cornerCount}; }
};
/// m² of a triangle, m³ of a tetrahedron.
double sizeOf(const TissueCell& cell, const std::vector<Eigen::Vector3d>& nodes);

/// The mean of its corners, m.
Eigen::Vector3d middleOf(const TissueCell& cell, const std::vector<Eigen::Vector3d>& nodes);

/// A strip by itself, between two clamps.
struct CutStrip {
    StripFrame frame;
    TissueModel tissue;                                ///< whose fixed nodes are those in the clamps
    std::vector<TissueCell> cells;                     ///< over its nodes
    std::array<std::vector<std::uint32_t>, 2> clamped; ///< nodes in the clamp before and behind the middle
};

/// A spring at the cut keeps the share that the strip's cells have of all cells at it, so that what is cut
/// off takes its part of the stiffness with it. Tethers, fluids and fixed nodes stay behind.
/// @throws InvalidModel as pullStrip()
CutStrip cutStrip(const ProbedOrgan& organ, const StripSettings& settings);

} // namespace esm
