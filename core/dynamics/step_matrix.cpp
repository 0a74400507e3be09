#include "core/dynamics/step_matrix.h"

#include "core/support/errors.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace esm {

namespace {

std::vector<int> freeIndices(const std::vector<char>& given) {
    std::vector<int> index(given.size(), -1);
    int next = 0;
    for (std::size_t i = 0; i < given.size(); ++i)
        if (!given[i]) index[i] = next++;
    return index;
}

/// What a spring or tether adds to the diagonal, and takes away beside it.
template<class Element> double coupling(const MatrixFactors& factors, const Element& element) {
    return factors.damping * element.viscosity + factors.stiffness * largestSpringConstant(element);
}

// A spring resists every motion of its ends alike in this matrix, be it along the spring or across it. The
// price is that it resists turning; what it buys is that x, y and z do not meet: one matrix with a row per
// node, a ninth of the entries of the true one, serves all three, and depends on no position.
Eigen::SparseMatrix<double> assemble(const SpringSystem& system, const MatrixFactors& factors,
                                     const std::vector<int>& index) {
    std::vector<double> diagonal(index.size());
    for (std::size_t i = 0; i < index.size(); ++i)
        diagonal[i] = factors.mass * system.mass[i];
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(index.size() + system.springs.size());
    for (const auto& spring : system.springs) {
        const double value = coupling(factors, spring);
        if (value == 0) continue;
        diagonal[spring.first] += value;
        diagonal[spring.second] += value;
        const auto [low, high] = std::minmax(index[spring.first], index[spring.second]);
        if (low >= 0) entries.emplace_back(high, low, -value);
    }
    for (const Tether& tether : system.tethers)
        diagonal[tether.node] += coupling(factors, tether);
    int size = 0;
    for (std::size_t i = 0; i < index.size(); ++i)
        if (index[i] >= 0) entries.emplace_back(index[i], index[i], diagonal[i]), ++size;
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

[[noreturn]] void refuseIllConditioned() {
    throw InvalidModel(
        "viscosity or stiffness outweighs mass by more than can be computed with: raise the mass, lower the "
        "viscosity or the spring constant, or tie more of the tissue with tethers");
}

} // namespace

Eigen::SparseMatrix<double> laplacianMatrix(const SpringSystem& system, const MatrixFactors& factors,
                                            const std::vector<char>& given) {
    return assemble(system, factors, freeIndices(given));
}

// Analysing, which finds an order of elimination with little fill-in and the places of the factor's entries,
// needs to know where entries are, not what they are. Where a slider moves parameters they stay in their
// places, so that it is done once for a network.
const Eigen::SimplicialLLT<MatrixFactoriser::Matrix>* MatrixFactoriser::factorise(const Matrix& matrix) {
    const auto start = std::chrono::steady_clock::now();
    if (!isAnalysed(matrix)) {
        m_solver.analyzePattern(matrix);
        m_starts.assign(matrix.outerIndexPtr(), matrix.outerIndexPtr() + matrix.outerSize() + 1);
        m_rows.assign(matrix.innerIndexPtr(), matrix.innerIndexPtr() + matrix.nonZeros());
    }
    m_solver.factorize(matrix);
    m_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return m_solver.info() == Eigen::Success ? &m_solver : nullptr;
}

bool MatrixFactoriser::isAnalysed(const Matrix& matrix) const {
    return m_starts.size() == static_cast<std::size_t>(matrix.outerSize()) + 1 &&
           m_rows.size() == static_cast<std::size_t>(matrix.nonZeros()) &&
           std::equal(m_starts.begin(), m_starts.end(), matrix.outerIndexPtr()) &&
           std::equal(m_rows.begin(), m_rows.end(), matrix.innerIndexPtr());
}

StepMatrix::StepMatrix(const SpringSystem& system, const MatrixFactors& factors,
                       const std::vector<char>& given, MatrixFactoriser& factoriser)
    : m_row(freeIndices(given)) {
    const Matrix matrix = assemble(system, factors, m_row);
    if (matrix.rows() > 0) {
        const auto* const factorisation = factoriser.factorise(matrix);
        if (!factorisation) refuseIllConditioned();
        m_lower = factorisation->matrixL().nestedExpression();
        for (int& row : m_row)
            if (row >= 0) row = factorisation->permutationP().indices()[row];
    }
    for (const auto& spring : system.springs) {
        const double factor = coupling(factors, spring);
        if (factor == 0) continue;
        const int first = m_row[spring.first], second = m_row[spring.second];
        if (first >= 0 && second < 0) m_couplings.push_back({first, spring.second, factor});
        if (second >= 0 && first < 0) m_couplings.push_back({second, spring.first, factor});
    }
    if (factors.damping != 0 || factors.stiffness != 0) checkAccuracy(system, factors);
}

void StepMatrix::solveLower(const Vectors& momentum, const Vectors& velocities, Vectors& half) const {
    half.resize(static_cast<std::size_t>(m_lower.cols()));
    for (std::size_t i = 0; i < m_row.size(); ++i)
        if (m_row[i] >= 0) half[static_cast<std::size_t>(m_row[i])] = momentum[i];
    for (const Coupling& coupling : m_couplings)
        half[static_cast<std::size_t>(coupling.row)] += coupling.factor * velocities[coupling.prescribedNode];

    const int* start = m_lower.outerIndexPtr();
    const int* row = m_lower.innerIndexPtr();
    const double* value = m_lower.valuePtr();
    for (std::size_t column = 0; column < half.size(); ++column) {
        int entry = start[column];
        const Eigen::Vector3d solved = half[column] / value[entry];
        half[column] = solved;
        for (++entry; entry < start[column + 1]; ++entry)
            half[static_cast<std::size_t>(row[entry])] -= value[entry] * solved;
    }
}

void StepMatrix::solveUpper(Vectors half, Vectors& velocities) const {
    const int* start = m_lower.outerIndexPtr();
    const int* row = m_lower.innerIndexPtr();
    const double* value = m_lower.valuePtr();
    for (std::size_t column = half.size(); column-- > 0;) {
        const int diagonal = start[column];
        Eigen::Vector3d sum = half[column];
        for (int entry = diagonal + 1; entry < start[column + 1]; ++entry)
            sum -= value[entry] * half[static_cast<std::size_t>(row[entry])];
        half[column] = sum / value[diagonal];
    }
    for (std::size_t i = 0; i < m_row.size(); ++i)
        if (m_row[i] >= 0) velocities[i] = half[static_cast<std::size_t>(m_row[i])];
}

void StepMatrix::multiplyUpper(const Vectors& velocities, Vectors& half) const {
    Vectors ordered(static_cast<std::size_t>(m_lower.cols()));
    for (std::size_t i = 0; i < m_row.size(); ++i)
        if (m_row[i] >= 0) ordered[static_cast<std::size_t>(m_row[i])] = velocities[i];
    half.assign(ordered.size(), Eigen::Vector3d::Zero());
    for (int column = 0; column < m_lower.outerSize(); ++column)
        for (Matrix::InnerIterator it(m_lower, column); it; ++it)
            half[static_cast<std::size_t>(column)] +=
                it.value() * ordered[static_cast<std::size_t>(it.row())];
}

// Solves L·x = e for one row's unit vector. Only the rows on the way from that row to the root of the
// elimination tree come out other than zero (Davis 2006), so that the way is walked first and only its rows
// are computed. Below a row of the way, its column's entries are on the way as well and in its order, so that
// one pass over the rest of the way meets them all.
HalfColumn StepMatrix::halfColumn(std::uint32_t node) const {
    const int* start = m_lower.outerIndexPtr();
    const int* row = m_lower.innerIndexPtr();
    const double* value = m_lower.valuePtr();

    HalfColumn result;
    for (int r = m_row[node]; r >= 0;) {
        result.rows.push_back(r);
        // In a Cholesky factor a column's first entry below the diagonal is its parent in the elimination
        // tree.
        r = start[r] + 1 < start[r + 1] ? row[start[r] + 1] : -1;
    }
    result.values.assign(result.rows.size(), 0.0);
    result.values[0] = 1;
    for (std::size_t i = 0; i < result.rows.size(); ++i) {
        int entry = start[result.rows[i]];
        const int end = start[result.rows[i] + 1];
        const double solved = result.values[i] /= value[entry];
        std::size_t target = i;
        for (++entry; entry < end; ++entry) {
            while (result.rows[target] != row[entry])
                ++target;
            result.values[target] -= value[entry] * solved;
        }
    }
    return result;
}

// The mode that rounding spoils first is all nodes moving as one: only mass, tethers and given nodes
// resist it, and on the diagonal their part is lost in that of springs where these are 10¹⁶ times as large.
// Cholesky's method need not fail there, but gives wrong velocities. So the matrix is applied to that mode by
// hand, where springs cancel exactly, and solved for again. A thousandth is far more than rounding does to a
// sound matrix.
void StepMatrix::checkAccuracy(const SpringSystem& system, const MatrixFactors& factors) const {
    Vectors momentum(system.mass.size()), velocities(system.mass.size(), Eigen::Vector3d::Ones()), half;
    for (std::size_t i = 0; i < momentum.size(); ++i)
        momentum[i].setConstant(factors.mass * system.mass[i]);
    for (const Tether& tether : system.tethers)
        momentum[tether.node].array() += coupling(factors, tether);
    solveLower(momentum, velocities, half);
    solveUpper(std::move(half), velocities);
    for (const Eigen::Vector3d& velocity : velocities)
        if (!(std::abs(velocity.x() - 1) < 1e-3)) refuseIllConditioned();
}

} // namespace esm
