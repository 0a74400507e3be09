#pragma once

#include "core/model/lattice.h"
#include "core/solid/narrow_crossings.h"

#include <cstddef>
#include <vector>

namespace esm {

/// What a filling comes to, within a quarter or so.
struct LatticeEstimate {
    double nodes, springs, tetrahedra;
    double bytes;   ///< of memory while the body is filled
    double spacing; ///< of the largest body, m: what was asked for, or less where that is thin
    NarrowCrossings crossings = {};
};

/// More nodes than this are refused.
inline constexpr double mostLatticeNodes = 1e6;

/// As many show how an organ gives way and still move in real time.
inline constexpr double usualLatticeNodes = 3000;

/// Tells for any spacing what a kind of lattice comes to in some bodies.
class LatticeEstimator {
public:
    /// @param bodies outlive this. Precondition: at least one, and no prisms
    LatticeEstimator(const std::vector<ClosedBody>& bodies, LatticeKind kind);
    LatticeEstimator(std::vector<ClosedBody>&&, LatticeKind) = delete;

    LatticeEstimate estimate(double spacing) const;
    /// Of one body alone.
    LatticeEstimate estimateIn(std::size_t body, double spacing) const;

private:
    const std::vector<ClosedBody>& m_bodies;
    LatticeKind m_kind;
    std::vector<std::vector<double>> m_depths; ///< per body, of places within, m; of a graded lattice
};

} // namespace esm
