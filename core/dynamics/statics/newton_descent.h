#pragma once

#include "core/dynamics/statics/least_tie.h"
#include "core/dynamics/statics/newton_way.h"
#include "core/dynamics/statics/resting_potential.h"
#include "core/dynamics/step_matrix.h"

#include <limits>

namespace esm {

/// Takes tissue that nothing touches downhill on its potential, by Newton's method.
class NewtonDescent {
public:
    /// @param system outlives this
    NewtonDescent(const SpringSystem& system, const RestingPotential& potential);

    /// As much of a way as lowers the potential; false where none does, and nothing has moved then.
    /// @param forces at the places, N; those on fixed nodes do not count
    /// @param longest m, that a node goes at most
    bool go(const RestingPotential& potential, Vectors forces, Vectors& positions,
            double longest = std::numeric_limits<double>::infinity());

    double stiffest() const { return m_stiffest; } ///< N/m, of all nodes

private:
    std::optional<NewtonWay> way(const RestingPotential& potential, const Vectors& forces,
                                 const Vectors& positions, double tie);

    const SpringSystem& m_system;
    MatrixFactoriser m_factoriser;
    Vectors m_rowPlaces; ///< m, of the matrix' rows
    LeastTie m_tie;
    double m_stiffest;
};

} // namespace esm
