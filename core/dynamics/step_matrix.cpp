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

/// What a spring or tether adds to the diagonal, and takes away beside it; of a hinge, what w·wᵀ is taken
/// with.
template<class Element> double coupling(const MatrixFactors& factors, const Element& element) {
    return factors.damping * element.viscosity + factors.stiffness * largestSpringConstant(element);
}

/// Visits the entries of κ·w·wᵀ of every hinge, those of two nodes once.
template<class Visit>
void forPairsOfHinges(const SpringSystem& system, const MatrixFactors& factors, const Visit& visit) {
    for (const auto& hinge : system.hinges) {
        const double value = coupling(factors, hinge);
        if (value == 0) continue;
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j <= i; ++j)
                visit(hinge.nodes[i], hinge.nodes[j], value * hinge.weights[i] * hinge.weights[j]);
    }
}

// A spring resists every motion of its ends alike in this matrix, be it along the spring or across it. The
// price is that it resists turning; what it buys is that x, y and z do not meet: one matrix with a row per
// node, a ninth of the entries of the true one, serves all three, and depends on no position. Of a hinge that
// is flat at rest it is the true one.
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
    forPairsOfHinges(system, factors, [&](std::uint32_t node, std::uint32_t other, double value) {
        if (node == other) diagonal[node] += value;
        const auto [low, high] = std::minmax(index[node], index[other]);
        if (node != other && low >= 0) entries.emplace_back(high, low, value);
    });
    for (const Tether& tether : system.tethers)
        diagonal[tether.node] += coupling(factors, tether);
    int size = 0;
    for (std::size_t i = 0; i < index.size(); ++i)
        if (index[i] >= 0) entries.emplace_back(index[i], index[i], diagonal[i]), ++size;
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

Vectors placesOfRows(const SpringSystem& system, const std::vector<int>& index) {
    Vectors places;
    places.reserve(index.size());
    for (std::size_t node = 0; node < index.size(); ++node)
        if (index[node] >= 0) places.push_back(system.network->restPositions[node]);
    return places;
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

// An order of elimination and the places of the factor's entries depend on where the matrix has entries, not
// on what they are. Where a slider moves parameters they stay in their places, so that all this is done once
// for a network.
std::optional<BlockFactor> MatrixFactoriser::factorise(const Matrix& matrix, const Vectors& places) {
    const auto start = std::chrono::steady_clock::now();
    if (!isPlanned(matrix, places)) {
        m_plan = std::make_shared<const FactorPlan>(planFactor(matrix, places));
        m_starts.assign(matrix.outerIndexPtr(), matrix.outerIndexPtr() + matrix.outerSize() + 1);
        m_rows.assign(matrix.innerIndexPtr(), matrix.innerIndexPtr() + matrix.nonZeros());
        m_places = places;
    }
    std::optional<BlockFactor> factor = BlockFactor::of(matrix, m_plan);
    m_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return factor;
}

bool MatrixFactoriser::isPlanned(const Matrix& matrix, const Vectors& places) const {
    return m_starts.size() == static_cast<std::size_t>(matrix.outerSize()) + 1 &&
           m_rows.size() == static_cast<std::size_t>(matrix.nonZeros()) &&
           std::equal(m_starts.begin(), m_starts.end(), matrix.outerIndexPtr()) &&
           std::equal(m_rows.begin(), m_rows.end(), matrix.innerIndexPtr()) && m_places == places;
}

StepMatrix::StepMatrix(const SpringSystem& system, const MatrixFactors& factors,
                       const std::vector<char>& given, MatrixFactoriser& factoriser)
    : m_row(freeIndices(given)) {
    std::optional<BlockFactor> factor =
        factoriser.factorise(assemble(system, factors, m_row), placesOfRows(system, m_row));
    if (!factor) refuseIllConditioned();
    m_factor = std::move(*factor);
    for (int& row : m_row)
        if (row >= 0) row = m_factor.places()[static_cast<std::size_t>(row)];
    for (const auto& spring : system.springs) {
        const double factor = coupling(factors, spring);
        if (factor == 0) continue;
        const int first = m_row[spring.first], second = m_row[spring.second];
        if (first >= 0 && second < 0) m_couplings.push_back({first, spring.second, factor});
        if (second >= 0 && first < 0) m_couplings.push_back({second, spring.first, factor});
    }
    forPairsOfHinges(system, factors, [this](std::uint32_t node, std::uint32_t other, double value) {
        if (m_row[node] >= 0 && m_row[other] < 0) m_couplings.push_back({m_row[node], other, -value});
        if (m_row[other] >= 0 && m_row[node] < 0) m_couplings.push_back({m_row[other], node, -value});
    });
    if (factors.damping != 0 || factors.stiffness != 0) checkAccuracy(system, factors);
}

void StepMatrix::solveLower(const Vectors& momentum, const Vectors& velocities, Vectors& half) const {
    half.resize(m_factor.rowCount());
    for (std::size_t i = 0; i < m_row.size(); ++i)
        if (m_row[i] >= 0) half[static_cast<std::size_t>(m_row[i])] = momentum[i];
    for (const Coupling& coupling : m_couplings)
        half[static_cast<std::size_t>(coupling.row)] += coupling.factor * velocities[coupling.prescribedNode];

    m_factor.solveLower(half);
}

void StepMatrix::solveUpper(Vectors half, Vectors& velocities) const {
    m_factor.solveUpper(half);
    for (std::size_t i = 0; i < m_row.size(); ++i)
        if (m_row[i] >= 0) velocities[i] = half[static_cast<std::size_t>(m_row[i])];
}

void StepMatrix::multiplyUpper(const Vectors& velocities, Vectors& half) const {
    Vectors ordered(m_factor.rowCount());
    for (std::size_t i = 0; i < m_row.size(); ++i)
        if (m_row[i] >= 0) ordered[static_cast<std::size_t>(m_row[i])] = velocities[i];
    half = m_factor.multiplyUpper(ordered);
}

std::vector<HalfColumn> StepMatrix::halfColumns(const std::vector<std::uint32_t>& nodes) const {
    std::vector<int> rows;
    rows.reserve(nodes.size());
    for (const std::uint32_t node : nodes)
        rows.push_back(m_row[node]);
    return m_factor.halfColumns(rows);
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
