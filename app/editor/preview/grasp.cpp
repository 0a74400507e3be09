#include "app/editor/preview/grasp.h"

#include "core/support/angles.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double graspRadius = 0.035; ///< of the organ's diagonal
constexpr double followTime = 0.03;   ///< s
constexpr double pullPeriod = 3.2;    ///< s
constexpr double pullReach = 0.1;     ///< of the organ's diagonal

bool isFixed(const TissueModel& model, std::uint32_t node) {
    return std::binary_search(model.fixedNodes.begin(), model.fixedNodes.end(), node);
}

} // namespace

std::vector<std::uint32_t> graspedNodes(const TissueModel& model, std::uint32_t node) {
    std::vector<std::uint32_t> nodes{node};
    const auto& rest = model.network->restPositions;
    const double radius = graspRadius * boundingBox(rest).diagonal().norm();
    for (std::uint32_t i = 0; i < rest.size(); ++i)
        if (i != node && !isFixed(model, i) && (rest[i] - rest[node]).norm() < radius) nodes.push_back(i);
    return nodes;
}

Grasp::Grasp(const TissueModel& model, const std::vector<Eigen::Vector3d>& positions, std::uint32_t node)
    : m_node(node), m_nodes(graspedNodes(model, node)) {
    for (const auto i : m_nodes)
        m_start.push_back(positions[i]);
}

void Grasp::advance(double timeStep, std::vector<HeldNode>& held) {
    m_displacement += (m_target - m_displacement) * (1 - std::exp(-timeStep / followTime));
    for (std::size_t i = 0; i < m_nodes.size(); ++i)
        held.push_back({m_nodes[i], m_start[i] + m_displacement});
}

std::optional<GentlePull> gentlePull(const TissueModel& model) {
    const auto& rest = model.network->restPositions;
    const auto box = boundingBox(rest);
    const Eigen::Vector3d direction = Eigen::Vector3d(0.8, 0.5, 0.35).normalized();
    std::optional<std::uint32_t> outermost;
    for (std::uint32_t i = 0; i < rest.size(); ++i)
        if (!isFixed(model, i) && (!outermost || rest[i].dot(direction) > rest[*outermost].dot(direction)))
            outermost = i;
    if (!outermost) return std::nullopt;
    return GentlePull{*outermost, pullReach * box.diagonal().norm() * direction};
}

Eigen::Vector3d displacementAt(const GentlePull& pull, double time) {
    return pull.furthest * (0.5 - 0.5 * std::cos(2 * pi * time / pullPeriod));
}

} // namespace esm
