#include "core/dynamics/statics/stretched_tissue.h"

#include "core/dynamics/forces.h"
#include "core/dynamics/statics/balance.h"
#include "core/dynamics/statics/line_search.h"
#include "core/support/errors.h"

#include <algorithm>

namespace esm {

namespace {

/// Of the tissue's size: what is left over then stretches no spring by a millionth.
constexpr double leastMove = 1e-4;

} // namespace

StretchedTissue::StretchedTissue(const SpringSystem& system, std::function<void()> checkpoint)
    : m_system(system), m_checkpoint(std::move(checkpoint)), m_potential(system),
      m_positions(system.network->restPositions), m_rowPlaces(restPlacesOfRows(system)) {
    const std::vector<double> stiffness = m_potential.nodeStiffness();
    m_stiffest = *std::max_element(stiffness.begin(), stiffness.end());
    m_size = boundingBox(m_positions).diagonal().norm();
}

// A stretched sheet resists across by its tension alone, and a slack one not at all: where the matrix is not
// positive, nodes are tied to where they are by as little as makes it so.
void StretchedTissue::settle(const Vectors& expected) {
    Vectors stayed = m_positions;
    for (std::size_t i = 0; i < stayed.size(); ++i)
        if (m_system.fixed[i]) stayed[i] = expected[i];
    if (m_potential.value(expected) < m_potential.value(stayed)) stayed = expected;
    m_positions = std::move(stayed);
    Vectors forces;
    const auto left = [&] {
        if (m_checkpoint) m_checkpoint();
        elasticForces(m_system, m_positions, forces);
        return imbalance(forces);
    };
    if (!findRest(balanced, left, [&] { return goDownhill(forces); }))
        throw InvalidModel("the stretched tissue finds no balance: stretch it less");
}

Eigen::Vector3d StretchedTissue::forceOn(const std::vector<std::uint32_t>& nodes) const {
    Vectors forces;
    elasticForces(m_system, m_positions, forces);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const std::uint32_t node : nodes)
        sum -= forces[node];
    return sum;
}

double StretchedTissue::leastForce() const {
    return nearlyBalanced * leastMove * m_size * m_stiffest;
}

/// What forces leave over, of those on the led nodes, or of what moves a node by next to nothing.
double StretchedTissue::imbalance(const Vectors& forces) const {
    double left = 0, led = 0;
    for (std::size_t i = 0; i < forces.size(); ++i) {
        double& largest = m_system.fixed[i] ? led : left;
        largest = std::max(largest, forces[i].norm());
    }
    return left / std::max(led, leastMove * m_size * m_stiffest);
}

/// As much of a way as lowers the potential; false where none does.
bool StretchedTissue::goDownhill(Vectors forces) {
    for (std::size_t i = 0; i < forces.size(); ++i)
        if (m_system.fixed[i]) forces[i].setZero(); // led nodes do not give way
    const auto way = m_tie.find(m_stiffest, [&](double tie) { return newtonWay(forces, tie); });
    if (!way) return false;
    Vectors tried(m_positions.size()), there;
    const auto at = [&](double part) {
        for (std::size_t i = 0; i < tried.size(); ++i)
            tried[i] = m_positions[i] + part * way->nodes[i];
        m_potential.forces(tried, there);
        return OnWay{m_potential.value(tried), -scalarProduct(there, way->nodes)};
    };
    const std::optional<double> part = lowerPart({m_potential.value(m_positions), way->slope}, at);
    if (!part) return false;
    at(*part);
    m_positions = std::move(tried);
    return true;
}

std::optional<NewtonWay> StretchedTissue::newtonWay(const Vectors& forces, double tie) {
    BlockEntries entries(m_system.fixed);
    m_potential.addStiffness(m_positions, entries);
    entries.addToDiagonal(tie);
    const std::optional<BlockFactor> factor = m_factoriser.factorise(entries.matrix(), m_rowPlaces);
    if (!factor) return {};
    const PushAlong none{0, 0, Vectors(forces.size(), Eigen::Vector3d::Zero())};
    return esm::newtonWay({*factor, entries, globalTermsOf(m_system, m_positions, 1)}, {forces, none, {}});
}

} // namespace esm
