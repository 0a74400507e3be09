#pragma once

#include "core/dynamics/block_entries.h"
#include "core/dynamics/loads.h"
#include "core/dynamics/motion.h"

#include <limits>
#include <optional>

namespace esm {

/// A step of time on which tissue goes on, or none: then it is at rest.
struct TimeLapse {
    double duration; ///< s
    Motion before;
};

/// What tissue lowers by moving: at rest the energy of its springs, hinges, tethers and fluids, less what
/// pressures from within do on the way from rest, p·(V − V₀). Over a time h it is what gives the step of the
/// implicit Euler rule,
///   E(x) + ½·(x − x₀ − h·v₀)ᵀ·M/h²·(x − x₀ − h·v₀) + ½·(x − x₀)ᵀ·D/h·(x − x₀),
/// with damping that is isotropic. Nodes that are fixed stay where they are.
class RestingPotential {
public:
    explicit RestingPotential(const SpringSystem& system) : m_system(system) {}

    void setLapse(std::optional<TimeLapse> lapse) { m_lapse = std::move(lapse); }
    /// From within, beside the fluids' own; each the same before and after.
    void setPressures(std::vector<CavityPressure> pressures) { m_loads.pressures = std::move(pressures); }

    double value(const Vectors& positions) const;                 ///< J
    void forces(const Vectors& positions, Vectors& forces) const; ///< N, in place of what was there
    /// Without what ties all nodes of a fluid's wall to each other (globalTermsOf()).
    void addStiffness(const Vectors& positions, BlockEntries& entries) const;
    /// N/m per node, of all that is at it.
    std::vector<double> nodeStiffness() const;

private:
    const SpringSystem& m_system;
    std::optional<TimeLapse> m_lapse;
    Loads m_loads; ///< pressures alone
};

/// m, of the rows of a matrix over the nodes that are not fixed.
Vectors restPlacesOfRows(const SpringSystem& system);

} // namespace esm
