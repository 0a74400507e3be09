#pragma once

#include "core/dynamics/statics/newton_descent.h"

#include <functional>

namespace esm {

/// Tissue whose fixed nodes are led away from where they rest, found by balance.
class StretchedTissue {
public:
    /// At rest.
    /// @param system whose fixed nodes are led; outlives this
    /// @param checkpoint called now and then within long work; what it throws goes through
    explicit StretchedTissue(const SpringSystem& system, std::function<void()> checkpoint = {});

    /// Where all forces cancel while the led nodes stand at `expected` places (m); the others' are where the
    /// search begins, unless those of before are better. @throws InvalidModel where no such place is found
    void settle(const Vectors& expected);

    const Vectors& positions() const { return m_positions; } ///< m
    /// N, that has to be laid on some of the led nodes to keep them there.
    Eigen::Vector3d forceOn(const std::vector<std::uint32_t>& nodes) const;
    /// N, of a node: what settle() may leave over. Smaller forces say nothing.
    double leastForce() const;

private:
    double imbalance(const Vectors& forces) const;

    const SpringSystem& m_system;
    std::function<void()> m_checkpoint;
    RestingPotential m_potential;
    NewtonDescent m_descent;
    Vectors m_positions;
    double m_size; ///< m, of all of it at rest
};

} // namespace esm
