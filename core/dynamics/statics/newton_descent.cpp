#include "core/dynamics/statics/newton_descent.h"

#include "core/dynamics/statics/line_search.h"

#include <algorithm>

namespace esm {

namespace {

void shorten(NewtonWay& way, double longest) {
    double most = 0;
    for (const Eigen::Vector3d& node : way.nodes)
        most = std::max(most, node.norm());
    if (most <= longest) return;
    for (Eigen::Vector3d& node : way.nodes)
        node *= longest / most;
    way.slope *= longest / most;
}

} // namespace

NewtonDescent::NewtonDescent(const SpringSystem& system, const RestingPotential& potential)
    : m_system(system), m_rowPlaces(restPlacesOfRows(system)) {
    const std::vector<double> stiffness = potential.nodeStiffness();
    m_stiffest = *std::max_element(stiffness.begin(), stiffness.end());
}

// A stretched sheet resists across by its tension alone, and a slack one not at all: where the matrix is not
// positive, nodes are tied to where they are by as little as makes it so.
bool NewtonDescent::go(const RestingPotential& potential, Vectors forces, Vectors& positions,
                       double longest) {
    for (std::size_t i = 0; i < forces.size(); ++i)
        if (m_system.fixed[i]) forces[i].setZero();
    auto found = m_tie.find(m_stiffest, [&](double tie) { return way(potential, forces, positions, tie); });
    if (!found) return false;
    shorten(*found, longest);
    Vectors tried(positions.size()), there;
    const auto at = [&](double part) {
        for (std::size_t i = 0; i < tried.size(); ++i)
            tried[i] = positions[i] + part * found->nodes[i];
        potential.forces(tried, there);
        return OnWay{potential.value(tried), -scalarProduct(there, found->nodes)};
    };
    const std::optional<double> part = lowerPart({potential.value(positions), found->slope}, at);
    if (!part) return false;
    at(*part);
    positions = std::move(tried);
    return true;
}

std::optional<NewtonWay> NewtonDescent::way(const RestingPotential& potential, const Vectors& forces,
                                            const Vectors& positions, double tie) {
    BlockEntries entries(m_system.fixed);
    potential.addStiffness(positions, entries);
    entries.addToDiagonal(tie);
    const std::optional<BlockFactor> factor = m_factoriser.factorise(entries.matrix(), m_rowPlaces);
    if (!factor) return {};
    const PushAlong none{0, 0, Vectors(forces.size(), Eigen::Vector3d::Zero())};
    return newtonWay({*factor, entries, globalTermsOf(m_system, positions, 1)}, {forces, none, {}});
}

} // namespace esm
