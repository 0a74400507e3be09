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
    Eigen::VectorXd vector; ///< in the basis that Lanczos built
};

Ritz largestRitzPair(const std::vector<double>& diagonal, const std::vector<double>& below) {
    const auto size = static_cast<Eigen::Index>(diagonal.size());
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
    solver.computeFromTridiagonal(Eigen::Map<const Eigen::VectorXd>(diagonal.data(), size),
                                  Eigen::Map<const Eigen::VectorXd>(below.data(), size - 1));
    const Eigen::VectorXd vector = solver.eigenvectors().col(size - 1);
    return {solver.eigenvalues()[size - 1], below.back() * std::abs(vector[size - 1]), vector};
}

/// Lanczos' three-term recurrence, one basis vector after the other.
class Lanczos {
public:
    Lanczos(const Eigen::SparseMatrix<double>& lower, Eigen::VectorXd start)
        : m_lower(lower), m_previous(Eigen::VectorXd::Zero(start.size())), m_current(std::move(start)) {}

    const Eigen::VectorXd& current() const { return m_current; }
    const std::vector<double>& diagonal() const { return m_diagonal; }
    const std::vector<double>& below() const { return m_below; }

    void multiply() {
        m_next = m_lower.selfadjointView<Eigen::Lower>() * m_current;
        if (!m_below.empty()) m_next -= m_below.back() * m_previous;
        m_diagonal.push_back(m_current.dot(m_next));
        m_next -= m_diagonal.back() * m_current;
        m_below.push_back(m_next.norm());
    }
    void goOn() {
        m_previous.swap(m_current);
        m_current = m_next / m_below.back();
    }

private:
    const Eigen::SparseMatrix<double>& m_lower;
    std::vector<double> m_diagonal, m_below;
    Eigen::VectorXd m_previous, m_current, m_next;
};

constexpr int mostIterations = 120;

/// Where to stop: rarely looked at from anywhere, often when the start is good.
bool isLookedAt(int iteration, int every) {
    return iteration % every == 0 || iteration == mostIterations;
}

struct Accuracy {
    double tolerance; ///< relative
    int lookEvery;    ///< iterations
};

/// Upper estimate of the eigenvalue, with the pair it is from.
std::pair<double, Ritz> lanczosEstimate(const Eigen::SparseMatrix<double>& lower,
                                        const Eigen::VectorXd& start, double bound,
                                        const Accuracy& accuracy) {
    Lanczos lanczos(lower, start);
    for (int iteration = 1;; ++iteration) {
        lanczos.multiply();
        const bool exhausted = lanczos.below().back() <= 1e-14 * bound;
        if (exhausted || isLookedAt(iteration, accuracy.lookEvery)) {
            Ritz ritz = largestRitzPair(lanczos.diagonal(), lanczos.below());
            if (exhausted || ritz.residual < accuracy.tolerance * ritz.value || iteration == mostIterations)
                return {std::min(bound, ritz.value + ritz.residual), std::move(ritz)};
        }
        lanczos.goOn();
    }
}

/// The pair's vector. The basis is built again instead of having been kept: it is large.
Eigen::VectorXd eigenvectorOf(const Ritz& ritz, const Eigen::SparseMatrix<double>& lower,
                              const Eigen::VectorXd& start) {
    Lanczos lanczos(lower, start);
    Eigen::VectorXd vector = ritz.vector[0] * start;
    for (Eigen::Index i = 1; i < ritz.vector.size(); ++i) {
        lanczos.multiply();
        lanczos.goOn();
        vector += ritz.vector[i] * lanczos.current();
    }
    return vector.normalized();
}

} // namespace

double largestEigenvalue(const Eigen::SparseMatrix<double>& lower) {
    if (lower.rows() == 0) return 0;
    const double bound = gershgorinBound(lower);
    if (!(bound > 0)) return 0;
    return lanczosEstimate(lower, startVector(lower.rows()), bound, {5e-4, 8}).first;
}

double largestEigenvalueNear(Eigen::VectorXd& eigenvector, const Eigen::SparseMatrix<double>& lower,
                             double tolerance) {
    if (lower.rows() == 0) return 0;
    const double bound = gershgorinBound(lower);
    if (!(bound > 0)) return 0;
    Eigen::VectorXd start = startVector(lower.rows());
    const bool isWarm = eigenvector.size() == lower.rows();
    // One half starts at the former eigenvector, the other finds what has overtaken it.
    if (isWarm) start = (eigenvector + start).normalized();
    const auto [value, ritz] = lanczosEstimate(lower, start, bound, {tolerance, isWarm ? 4 : 8});
    eigenvector = eigenvectorOf(ritz, lower, start);
    return value;
}

} // namespace esm
