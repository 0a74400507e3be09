#pragma once

namespace esm {

/// Of the matrix massFactor·M + dampingFactor·D + stiffnessFactor·K: see laplacianMatrix().
struct MatrixFactors {
    double mass, damping, stiffness;
};

} // namespace esm
