#pragma once

#include "core/model/integrators.h"

#include <Eigen/SparseCholesky>

#include <map>

namespace esm {

/// What a search for critical steps leaves behind for the next one, of the same tissue with other parameters.
/// It changes how long that one takes, and what it finds by no more than its tolerance.
struct StabilityMemory {
    using Matrix = Eigen::SparseMatrix<double>;

    Matrix pattern;                         ///< what the solver has analysed; the numbers mean nothing
    Eigen::SimplicialLLT<Matrix> solver;    ///< ready to factorise what has the pattern
    Eigen::VectorXd stiffest, mostDamped;   ///< eigenvectors of stiffness and damping, mass-normalised
    std::map<Integrator, double> overGuess; ///< critical step over the first guess at it
};

} // namespace esm
