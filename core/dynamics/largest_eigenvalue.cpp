#include "core/dynamics/largest_eigenvalue.h"

#include <Eigen/Eigenvalues>

#include <random>
#include <utility>
#include <vector>

namespace esm {

namespace {

double gershgorinBound(const Eigen::SparseMatrix<double>& lower) {
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(lower.rows());
    for (int column = 0; column < lower.outerSize(); ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator it(lower, column); it; ++it) {
            sums[it.row()] += std::abs(it.value());
            if (it.row() != column) sums[column] += std::abs(it.value());
        }
    return sums.maxCoeff();
}

// The same on every machine, unlike the library's distributions.
Eigen::VectorXd startVector(Eigen::Index size) {
    std::minstd_rand random(1);
    Eigen::VectorXd start(size);
    for (double& value : start)
        value = static_cast<double>(random()) / static_cast<double>(std::minstd_rand::max()) - 0.5;
    return start.normalized();
}

struct Ritz {
    double value, residual;
};

Ritz largestRitzValue(const std::vector<double>& diagonal, const std::vector<double>& below) {
    const auto size = static_cast<Eigen::Index>(diagonal.size());
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
    solver.computeFromTridiagonal(Eigen::Map<const Eigen::VectorXd>(diagonal.data(), size),
                                  Eigen::Map<const Eigen::VectorXd>(below.data(), size - 1));
    return {solver.eigenvalues()[size - 1],
            below.back() * std::abs(solver.eigenvectors()(size - 1, size - 1))};
}

} // namespace

double largestEigenvalue(const Eigen::SparseMatrix<double>& lower) {
    if (lower.rows() == 0) return 0;
    const double bound = gershgorinBound(lower);
    if (!(bound > 0)) return 0;
    constexpr int mostIterations = 120, checkEvery = 8;
    std::vector<double> diagonal, below;
    Eigen::VectorXd previous = Eigen::VectorXd::Zero(lower.rows()), current = startVector(lower.rows());
    for (int iteration = 1; iteration <= mostIterations; ++iteration) {
        Eigen::VectorXd next = lower.selfadjointView<Eigen::Lower>() * current;
        if (!below.empty()) next -= below.back() * previous;
        diagonal.push_back(current.dot(next));
        next -= diagonal.back() * current;
        below.push_back(next.norm());
        const bool exhausted = below.back() <= 1e-14 * bound;
        if (exhausted || iteration % checkEvery == 0) {
            const Ritz ritz = largestRitzValue(diagonal, below);
            if (exhausted || ritz.residual < 5e-4 * ritz.value || iteration == mostIterations)
                return std::min(bound, ritz.value + ritz.residual);
        }
        previous = std::exchange(current, next / below.back());
    }
    return bound;
}

} // namespace esm
