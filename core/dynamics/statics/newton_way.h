#pragma once

#include "core/dynamics/elimination/block_factor.h"
#include "core/dynamics/global_terms.h"
#include "core/dynamics/statics/sphere_contacts.h"

#include <optional>

namespace esm {

/// A change of a sphere's depth and of the nodes' places, downhill.
struct NewtonWay {
    double depth;  ///< m
    Vectors nodes; ///< m
    double slope;  ///< J, of the potential along all of it: below 0
};

/// What is asked for: that forces on nodes and on the sphere cancel.
struct Unbalanced {
    const Vectors& forces;        ///< N, on the nodes
    const PushAlong& push;        ///< of the sphere along its line
    std::optional<double> pushed; ///< N, on the sphere; none: it stays at its depth
};

/// The curvature of a potential: a sparse matrix, and what stands beside it.
struct PotentialCurvature {
    const BlockFactor& factor;
    const BlockEntries& rows; ///< of the matrix that the factor is of
    const GlobalTerms& terms; ///< N/m
};

/// A step of Newton's method. None where it would not go downhill.
std::optional<NewtonWay> newtonWay(const PotentialCurvature& curvature, const Unbalanced& unbalanced);

} // namespace esm
