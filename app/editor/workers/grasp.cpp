#include "app/editor/workers/grasp.h"

#include "core/support/angles.h"

#include <cmath>

namespace esm {

namespace {

constexpr double followTime = 0.03; ///< s
constexpr double pullPeriod = 3.2;  ///< s

} // namespace

Grasp::Grasp(const TissueModel& model, const std::vector<Eigen::Vector3d>& positions, std::uint32_t node)
    : m_node(node), m_nodes(graspedNodes(model, node)) {
    for (const auto i : m_nodes)
        m_start.push_back(positions[i]);
}

void Grasp::advance(double timeStep, std::vector<PrescribedNode>& prescribed) {
    m_displacement += (m_target - m_displacement) * (1 - std::exp(-timeStep / followTime));
    for (std::size_t i = 0; i < m_nodes.size(); ++i)
        prescribed.push_back({m_nodes[i], m_start[i] + m_displacement});
}

Eigen::Vector3d displacementAt(const GentlePull& pull, double time) {
    return pull.furthest * (0.5 - 0.5 * std::cos(2 * pi * time / pullPeriod));
}

} // namespace esm
