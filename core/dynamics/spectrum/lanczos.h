#pragma once

#include "core/dynamics/spectrum/symmetric_sum.h"

#include <functional>

namespace esm {

/// An approximation of the largest eigenvalue of a symmetric matrix, above it by no more than rounding, and
/// how far it may be from an eigenvalue.
struct RitzPair {
    double value, residual;
    Eigen::VectorXd coefficients; ///< of its vector in the basis that was built
};

struct LanczosLimits {
    std::function<bool(const RitzPair&)> isEnough; ///< asked every few iterations
    int leastIterations = 1, mostIterations = 120;
};

RitzPair largestRitzPair(const SymmetricSum& matrix, const Eigen::VectorXd& start,
                         const LanczosLimits& limits);

/// The pair's vector, of length 1, from the same matrix and start. The basis is built again instead of having
/// been kept: it is large.
Eigen::VectorXd ritzVector(const RitzPair& pair, const SymmetricSum& matrix, const Eigen::VectorXd& start);

/// A direction that prefers none, of length 1; the same on every machine.
Eigen::VectorXd arbitraryDirection(Eigen::Index size);

/// Iterations after which a largest eigenvalue that stands out by this share of the spectrum's width has
/// hardly escaped notice, from an arbitrary direction.
int iterationsToNotice(double share, Eigen::Index size);

} // namespace esm
