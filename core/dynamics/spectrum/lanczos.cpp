#include "core/dynamics/spectrum/lanczos.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace esm {

namespace {

/// A symmetric tridiagonal matrix; the last entry below the diagonal lies outside it.
struct Tridiagonal {
    std::vector<double> diagonal, below;
};

/// Sturm's test: a number is above all eigenvalues exactly where shift − T is positive definite, that is
/// where all pivots of its elimination are positive.
bool liesAboveSpectrum(double shift, const Tridiagonal& matrix) {
    double pivot = shift - matrix.diagonal[0];
    for (std::size_t i = 1; i < matrix.diagonal.size() && pivot > 0; ++i)
        pivot = shift - matrix.diagonal[i] - matrix.below[i - 1] * matrix.below[i - 1] / pivot;
    return pivot > 0;
}

struct Bracket {
    double below, above;
};

Bracket gershgorinBracket(const Tridiagonal& matrix) {
    double most = matrix.diagonal[0], scale = 0;
    for (std::size_t i = 0; i < matrix.diagonal.size(); ++i) {
        const double before = i > 0 ? matrix.below[i - 1] : 0;
        const double after = i + 1 < matrix.diagonal.size() ? matrix.below[i] : 0;
        most = std::max(most, matrix.diagonal[i] + before + after);
        scale = std::max(scale, std::abs(matrix.diagonal[i]) + before + after);
    }
    const double largest = *std::max_element(matrix.diagonal.begin(), matrix.diagonal.end());
    return {largest, most + 1e-12 * scale + std::numeric_limits<double>::min()};
}

/// The largest eigenvalue between two numbers a rounding apart. Halving is slow beside other methods, but T
/// has some hundreds of rows at most, nothing here can fail to converge, and the upper end is above the
/// eigenvalue for sure. The largest entry of the diagonal is below it, as every Rayleigh quotient is.
Bracket largestEigenvalue(const Tridiagonal& matrix) {
    Bracket bracket = gershgorinBracket(matrix);
    const double width = 1e-15 * std::max(std::abs(bracket.below), std::abs(bracket.above));
    while (bracket.above - bracket.below > width) {
        const double middle = bracket.below + (bracket.above - bracket.below) / 2;
        if (middle <= bracket.below || middle >= bracket.above) break;
        (liesAboveSpectrum(middle, matrix) ? bracket.above : bracket.below) = middle;
    }
    return bracket;
}

/// Solves (shift − T)·x = x, a positive definite system, and makes the solution's length 1.
void iterateInversely(const Tridiagonal& matrix, double shift, Eigen::VectorXd& x) {
    const Eigen::Index size = x.size();
    Eigen::VectorXd pivots(size);
    const auto at = [](const std::vector<double>& values, Eigen::Index i) {
        return values[static_cast<std::size_t>(i)];
    };
    pivots[0] = shift - at(matrix.diagonal, 0);
    for (Eigen::Index i = 1; i < size; ++i) {
        const double factor = at(matrix.below, i - 1) / pivots[i - 1];
        pivots[i] = shift - at(matrix.diagonal, i) - factor * at(matrix.below, i - 1);
        x[i] += factor * x[i - 1];
    }
    x[size - 1] /= pivots[size - 1];
    for (Eigen::Index i = size - 1; i-- > 0;)
        x[i] = (x[i] + at(matrix.below, i) * x[i + 1]) / pivots[i];
    x.normalize();
}

// Inverse iteration from just above the eigenvalue finds its vector in two steps: all of its entries are
// positive (Perron and Frobenius, since all of T beside the diagonal is), and so are those of the start,
// which therefore is not across it. The residual of a Ritz pair is the last entry of its vector times the
// last number below the diagonal (Parlett 1980).
RitzPair largestPairOf(const Tridiagonal& matrix) {
    const auto size = static_cast<Eigen::Index>(matrix.diagonal.size());
    const double above = largestEigenvalue(matrix).above;
    Eigen::VectorXd vector = Eigen::VectorXd::Ones(size);
    for (int i = 0; i < 2; ++i)
        iterateInversely(matrix, above, vector);
    return {above, matrix.below.back() * std::abs(vector[size - 1]), std::move(vector)};
}

/// Lanczos' three-term recurrence (1950), one basis vector after the other. They are not made orthogonal to
/// all of those before. With rounding they cease to be once an eigenvalue has converged, and copies of it
/// turn up; but copies do no harm to who looks for the largest alone (Paige 1971), and neither time nor
/// memory grows with the square of the iterations.
class Lanczos {
public:
    Lanczos(const SymmetricSum& matrix, Eigen::VectorXd start)
        : m_matrix(matrix), m_previous(Eigen::VectorXd::Zero(start.size())), m_current(std::move(start)) {}

    const Eigen::VectorXd& current() const { return m_current; }
    const Tridiagonal& projected() const { return m_projected; }

    void multiply() {
        m_next = m_matrix.times(m_current);
        if (!m_projected.below.empty()) m_next -= m_projected.below.back() * m_previous;
        m_projected.diagonal.push_back(m_current.dot(m_next));
        m_next -= m_projected.diagonal.back() * m_current;
        m_projected.below.push_back(m_next.norm());
    }
    void goOn() {
        m_previous.swap(m_current);
        m_current = m_next / m_projected.below.back();
    }
    /// Whether the basis spans all that the matrix makes of the start.
    bool isExhausted() const {
        const auto [below, above] = gershgorinBracket(m_projected);
        return m_projected.below.back() <= 1e-14 * std::max(std::abs(below), std::abs(above));
    }

private:
    const SymmetricSum& m_matrix;
    Tridiagonal m_projected;
    Eigen::VectorXd m_previous, m_current, m_next;
};

} // namespace

RitzPair largestRitzPair(const SymmetricSum& matrix, const Eigen::VectorXd& start,
                         const LanczosLimits& limits) {
    constexpr int lookEvery = 4;
    Lanczos lanczos(matrix, start);
    for (int iteration = 1;; ++iteration) {
        lanczos.multiply();
        const bool isLast = iteration >= limits.mostIterations || lanczos.isExhausted();
        if (isLast || (iteration % lookEvery == 0 && iteration >= limits.leastIterations)) {
            RitzPair pair = largestPairOf(lanczos.projected());
            if (isLast || limits.isEnough(pair)) return pair;
        }
        lanczos.goOn();
    }
}

Eigen::VectorXd ritzVector(const RitzPair& pair, const SymmetricSum& matrix, const Eigen::VectorXd& start) {
    Lanczos lanczos(matrix, start);
    Eigen::VectorXd vector = pair.coefficients[0] * start;
    for (Eigen::Index i = 1; i < pair.coefficients.size(); ++i) {
        lanczos.multiply();
        lanczos.goOn();
        vector += pair.coefficients[i] * lanczos.current();
    }
    return vector.normalized();
}

// Not by the library's distributions, which differ from one machine to another.
Eigen::VectorXd arbitraryDirection(Eigen::Index size) {
    std::minstd_rand random(1);
    Eigen::VectorXd start(size);
    for (double& value : start)
        value = static_cast<double>(random()) / static_cast<double>(std::minstd_rand::max()) - 0.5;
    return start.normalized();
}

// Kuczyński and Woźniakowski (1992), theorem 4: missed with a probability of at most
// 1.65·√size·exp(−(2·iterations − 1)·√share), here a tenth. Their bound holds for any spectrum.
int iterationsToNotice(double share, Eigen::Index size) {
    const double odds = std::log(16.5 * std::sqrt(static_cast<double>(size)));
    return static_cast<int>(std::ceil((odds / std::sqrt(share) + 1) / 2));
}

} // namespace esm
