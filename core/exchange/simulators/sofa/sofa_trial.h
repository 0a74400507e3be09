#pragma once

#include "core/exchange/simulators/handover.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace esm {

/// One motion of an organ here and in SOFA.
struct SofaTrial {
    std::vector<double> times;       ///< s, from the start on
    std::vector<double> here, there; ///< m, how far the node that moves farthest here, of those that nothing
                                     ///< leads, is from rest then
    double error =
        0; ///< of all nodes at all times, relative to the motion here: √(Σ|x − x_here|² / Σ|x_here − x_0|²)
    double timeStep = 0;                ///< s, in SOFA
    double wallHere = 0, wallThere = 0; ///< s of computing per simulated second
};

/// Moves an organ by the forces, led nodes and gravity of its scene, here and in an installed SOFA without a
/// window. Here that is once to an error of 10⁻⁴ of the motion, which SOFA's is held against, and once in the
/// usual way, which tells how long it takes. SOFA writes six digits of a place; what nodes that stand still
/// lose by that is taken out.
/// @throws InvalidModel where nothing moves, or no step comes as near as that; what handoverOf() and
/// runInSofa() throw
SofaTrial tryInSofa(const std::filesystem::path& program, Project project, const HandoverMeans& means);

} // namespace esm
