#pragma once

#include "core/dynamics/spring_system.h"

namespace esm {

/// Which springs are beyond the strain of their law, for a constant matrix: it takes these with the constant
/// beyond the strain, all others with the one up to it. Which they are changes seldom, so that a factorised
/// matrix stays of use.
class StrainedSprings {
public:
    /// Whether there are springs that become stiffer at all.
    explicit StrainedSprings(const SpringSystem& system);
    bool canChange() const { return m_canChange; }

    /// Takes in what is strained at these places, and lets others go where they have become the larger part.
    /// With springs that are strained come those that soon will be. Whether anything changed.
    bool follow(const SpringSystem& system, const Vectors& positions);
    /// The same without letting others go.
    bool add(const SpringSystem& system, const Vectors& positions);
    void addAll();

    /// The same tissue with linear springs.
    SpringSystem linearised(const SpringSystem& system) const;

private:
    bool m_canChange;
    std::vector<char> m_isStrained; ///< per spring
};

} // namespace esm
