#include "core/dynamics/statics/stretched_tissue.h"

#include "core/dynamics/forces.h"
#include "core/dynamics/statics/balance.h"
#include "core/support/errors.h"

#include <algorithm>

namespace esm {

namespace {

/// Of the tissue's size: what is left over then stretches no spring by a millionth.
constexpr double leastMove = 1e-4;

} // namespace

StretchedTissue::StretchedTissue(const SpringSystem& system, std::function<void()> checkpoint)
    : m_system(system), m_checkpoint(std::move(checkpoint)), m_potential(system),
      m_descent(system, m_potential), m_positions(system.network->restPositions),
      m_size(boundingBox(m_positions).diagonal().norm()) {}

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
    if (!findRest(balanced, left, [&] { return m_descent.go(m_potential, forces, m_positions); }))
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
    return nearlyBalanced * leastMove * m_size * m_descent.stiffest();
}

/// What forces leave over, of those on the led nodes, or of what moves a node by next to nothing.
double StretchedTissue::imbalance(const Vectors& forces) const {
    double left = 0, led = 0;
    for (std::size_t i = 0; i < forces.size(); ++i) {
        double& largest = m_system.fixed[i] ? led : left;
        largest = std::max(largest, forces[i].norm());
    }
    return left / std::max(led, leastMove * m_size * m_descent.stiffest());
}

} // namespace esm
